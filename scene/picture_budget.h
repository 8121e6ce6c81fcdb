#pragma once

#include <cstddef>

namespace enfilade {

/// Keeps count of the pixels that a file's pictures are decoded to: many pictures may be named of
/// one part of a file, and a few bytes may say that they are many pixels.
class PictureBudget {
 public:
  /// False if the pixels of all pictures so far are far more than `bytes` can hold.
  bool add(std::size_t pixels, std::size_t bytes) noexcept {
    constexpr std::size_t kAlways = std::size_t{1} << 26;
    constexpr std::size_t kEachByte = 512;
    pixels_ += pixels;
    return pixels_ <= kAlways || (pixels_ - kAlways) / kEachByte <= bytes;
  }

  std::size_t pixels() const noexcept { return pixels_; }

 private:
  std::size_t pixels_ = 0;
};

}  // namespace enfilade
