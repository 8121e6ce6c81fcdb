#include "ibr/warp_scratch.h"

#include <algorithm>

namespace enfilade {
namespace {

/// Makes room for `size` things, and sets the window's own to `empty`.
template <class T>
T* clearedWindow(std::vector<T>& pixels, std::size_t size, std::ptrdiff_t origin,
                 const WarpWindow& window, const T& empty) {
  if (pixels.size() < size) pixels.resize(size);
  T* const at = pixels.data() + origin;
  for (int y = window.top; y < window.bottom; ++y) {
    T* const row = at + y * window.stride;
    std::fill(row + window.left, row + std::max(window.left, window.right), empty);
  }
  return at;
}

}  // namespace

WarpWindow WorkingPicture::window(const glm::ivec4& box, int frame_width, int frame_height,
                                  Splat splat) {
  WarpWindow window;
  window.left = box.x;
  window.top = box.y;
  window.right = box.z;
  window.bottom = box.w;
  window.stride = frame_width + 2 * kWindowBorder;
  const std::size_t size = static_cast<std::size_t>(window.stride) *
                           static_cast<std::size_t>(frame_height + 2 * kWindowBorder);
  const std::ptrdiff_t origin = kWindowBorder * window.stride + kWindowBorder;
  if (splat == Splat::kNearest) {
    window.closeness = clearedWindow(closeness_, size, origin, window, 0.0f);
  }
  if (keepsDepth(splat)) {
    window.sums = clearedWindow(sums_, size, origin, window, std::uint64_t{0});
    window.nearest = clearedWindow(nearest_, size, origin, window, 0.0f);
  } else {
    window.painted = clearedWindow(painted_, size, origin, window, 0u);
  }
  return window;
}

}  // namespace enfilade
