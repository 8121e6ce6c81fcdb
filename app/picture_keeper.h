#pragma once

#include <span>
#include <string>

#include "app/methods.h"
#include "scene/image.h"

namespace enfilade {

inline constexpr int kKeptWidth = 320;                      ///< [pixels] at most, of a kept picture
inline constexpr int kKeptQuality = 80;                     ///< of its JPEG
inline constexpr const char* kPicturesFolder = "pictures";  ///< in the report

/// Keeps small pictures of a walk's frames, evenly spaced, for the report to show: one of `stride`
/// frames, the first among them, as FOLDER/METHOD/00012.jpg.
class PictureKeeper {
 public:
  PictureKeeper() = default;  ///< keeps nothing
  /// Keeps at most `most` of `frames` a method; `most` 0: none.
  PictureKeeper(std::string folder, std::size_t frames, std::size_t most);

  std::size_t stride() const noexcept { return stride_; }  ///< 0: keeps nothing
  bool keeps(std::size_t frame) const noexcept { return stride_ > 0 && frame % stride_ == 0; }

  /// Makes the folders.  Throws Error (kMachine), as keep() does.
  void begin(std::span<const Method> methods) const;
  void keep(Method method, std::size_t frame, const Image& picture) const;

 private:
  std::string folder_;
  std::size_t stride_ = 0;
};

/// `image` at most kKeptWidth wide, by the means of squares of pixels; never made larger.
Image keptSize(const Image& image);

}  // namespace enfilade
