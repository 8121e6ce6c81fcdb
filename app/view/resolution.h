#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace enfilade {

/// How finely frames are painted while one moves, so that the picture answers at once on a slow
/// machine; whoever stands still sees every pixel.
class Resolution {
 public:
  /// Full resolution always, or as the frames' times allow.
  void setFixed(bool fixed) { fixed_ = fixed; }
  bool fixed() const noexcept { return fixed_; }

  /// Takes note of what a frame took that was painted while moving [ms].
  void note(double frame_ms);

  /// The size to paint for a window of `window` pixels.
  glm::ivec2 sizeFor(const glm::ivec2& window, bool moving) const;

  bool reduced() const noexcept { return !fixed_ && level_ > 0; }

 private:
  std::size_t level_ = 0;
  bool fixed_ = false;
};

}  // namespace enfilade
