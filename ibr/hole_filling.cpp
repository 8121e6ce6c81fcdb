#include "ibr/hole_filling.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "ibr/warp.h"

namespace enfilade {
namespace {

constexpr std::array<HolesInfo, 3> kHoles = {{
    {Holes::kNothing, "none", "whatever is drawn there otherwise"},
    {Holes::kPersist, "persist", "the pixels of the frame before"},
    {Holes::kInpaint, "inpaint", "what surrounds the hole, grown inward"},
}};

std::uint8_t* pixelAt(Image& image, int x, int y) noexcept {
  return image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
}

/// Part of a picture.
struct Part {
  std::span<const glm::ivec2> spans;
  int top, bottom;

  bool contains(int x, int y) const noexcept {
    if (y < top || y >= bottom) return false;
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    return span.x <= x && x < span.y;
  }
};

/// The mean of the known pixels around (x, y); 0 where there is none.
std::uint32_t meanAround(Image& picture, const Part& part, const glm::ivec2& at) noexcept {
  std::array<unsigned, 3> sum{};
  unsigned known = 0;
  for (int y = at.y - 1; y <= at.y + 1; ++y) {
    for (int x = at.x - 1; x <= at.x + 1; ++x) {
      if (!part.contains(x, y)) continue;
      const std::uint8_t* const pixel = pixelAt(picture, x, y);
      if (pixel[3] == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
      ++known;
    }
  }
  if (known == 0) return 0;
  const auto mean = [&](std::size_t c) { return (sum[c] + known / 2) / known; };
  return std::uint32_t{kAlphaOfFilling} << 24 | mean(2) << 16 | mean(1) << 8 | mean(0);
}

}  // namespace

std::span<const HolesInfo> allHoles() { return kHoles; }

void HoleFiller::persist(const Image& before, std::span<const glm::ivec2> spans, int top,
                         int bottom, Image& picture) noexcept {
  for (int y = top; y < bottom; ++y) {
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    for (int x = span.x; x < span.y; ++x) {
      std::uint8_t* const pixel = pixelAt(picture, x, y);
      if (pixel[3] != 0) continue;
      const std::uint8_t* const was = before.rgba.data() + (pixel - picture.rgba.data());
      if (was[3] == 0) continue;
      std::memcpy(pixel, was, 3);
      pixel[3] = kAlphaOfFilling;
    }
  }
}

void HoleFiller::inpaint(std::span<const glm::ivec2> spans, int top, int bottom, Image& picture) {
  holes_.clear();
  for (int y = top; y < bottom; ++y) {
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    for (int x = span.x; x < span.y; ++x) {
      if (pixelAt(picture, x, y)[3] == 0) holes_.emplace_back(x, y);
    }
  }
  const Part part{spans, top, bottom};
  for (int ring = 0; ring < kMostRings && !holes_.empty(); ++ring) {
    colors_.clear();
    for (const glm::ivec2& hole : holes_) colors_.push_back(meanAround(picture, part, hole));
    std::size_t left = 0;
    for (std::size_t i = 0; i < holes_.size(); ++i) {
      if (colors_[i] == 0) {
        holes_[left++] = holes_[i];
      } else {
        std::memcpy(pixelAt(picture, holes_[i].x, holes_[i].y), &colors_[i], 4);
      }
    }
    if (left == holes_.size()) break;  // nothing is known anywhere near
    holes_.resize(left);
  }
}

}  // namespace enfilade
