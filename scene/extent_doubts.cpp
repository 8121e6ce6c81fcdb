#include "scene/extent_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kFineStep = 0.003f;                    // [m] that no door or window suffers from
constexpr float kLongest = 2000.0f, kShortest = 2.0f;  // [m] that a building is

float farthestOf(const Box& bounds) {
  const glm::vec3 far = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  return std::max({far.x, far.y, far.z});
}

}  // namespace

float coordinateStep(const Box& bounds) {
  if (bounds.empty()) return 0;
  const float farthest = farthestOf(bounds);
  return farthest - std::nextafter(farthest, 0.0f);
}

std::string lengthText(float length) {
  const float size = std::abs(length);
  if (size < 0.1f) return fmt::format("{:.2g} mm", length * 1000);
  if (size < 1000) return fmt::format("{:.2f} m", length);
  return fmt::format("{:.0f} km", std::round(length / 1000));
}

std::vector<std::string> extentDoubts(const Box& bounds) {
  std::vector<std::string> doubts;
  if (bounds.empty()) return doubts;
  const glm::vec3 size = bounds.size();
  const float longest = std::max({size.x, size.y, size.z});
  if (longest > kLongest) {
    doubts.push_back(fmt::format("{:.0f} m long: is the model in metres?", longest));
  } else if (longest < kShortest) {
    doubts.push_back(fmt::format("only {:.2g} m long: is the model in metres?", longest));
  } else if (size.y > 2 * std::max(size.x, size.z)) {
    doubts.push_back("more than twice as high as it is long: does +Y point up?");
  }
  const float step = coordinateStep(bounds);
  if (longest <= kLongest && step > kFineStep) {
    doubts.push_back(
        fmt::format("{} from the origin, where coordinates lie {} apart: move it nearer",
                    lengthText(farthestOf(bounds)), lengthText(step)));
  }
  return doubts;
}

}  // namespace enfilade
