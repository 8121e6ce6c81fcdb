#include "app/view/resolution.h"

namespace enfilade {

namespace {

constexpr std::array<float, 4> kScales = {1.0f, 0.75f, 0.5f, 0.35f};
constexpr double kTooSlow = 45;     // [ms] a frame: coarser
constexpr double kFastEnough = 30;  // [ms] that a finer frame would take: finer

}  // namespace

void Resolution::note(double frame_ms) {
  if (frame_ms > kTooSlow && level_ + 1 < kScales.size()) {
    ++level_;
  } else if (level_ > 0) {
    // Time grows with the pixels at most.
    const auto sides = static_cast<double>(kScales[level_ - 1] / kScales[level_]);
    if (frame_ms * sides * sides < kFastEnough) --level_;
  }
}

glm::ivec2 Resolution::sizeFor(const glm::ivec2& window, bool moving) const {
  if (fixed_ || !moving) return glm::max(window, 1);
  return glm::max(glm::ivec2(kScales[level_] * glm::vec2(window)), 1);
}

}  // namespace enfilade
