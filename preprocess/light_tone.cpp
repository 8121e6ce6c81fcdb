#include "preprocess/light_tone.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr float kIndoors = 0.05f;  // of the directions lead to the sky at most

/// The value in the middle of the weight; 0 without any.
float weightedMedian(std::vector<std::pair<float, float>>& weighted) {
  std::sort(weighted.begin(), weighted.end());
  double whole = 0, sum = 0;
  for (const auto& [value, weight] : weighted) whole += static_cast<double>(weight);
  for (const auto& [value, weight] : weighted) {
    sum += static_cast<double>(weight);
    if (2 * sum >= whole) return value;
  }
  return 0;
}

}  // namespace

glm::vec3 LightTone::shade(const glm::vec3& light) const noexcept {
  const float bright = luminance(light);
  if (!(bright > 0)) return glm::vec3(0);
  const float toned = 1 - std::exp(-exposure * bright);
  const glm::vec3 color = light * (toned / bright);
  // What does not fit goes towards white of the same luminance.
  const float most = std::max({color.r, color.g, color.b});
  if (most <= 1) return color;
  const float keep = (1 - toned) / (most - toned);
  return glm::clamp(glm::mix(glm::vec3(toned), color, keep), 0.0f, 1.0f);
}

LightTone toneFor(const LightPoints& points, const GatheredLight& gathered,
                  std::span<const glm::vec3> light, float mid_tone) {
  std::vector<std::pair<float, float>> indoors, lit;
  for (const LightChunk& chunk : gathered.chunks) {
    for (std::size_t k = 0; k < chunk.direct.size(); ++k) {
      const std::size_t i = chunk.first + k;
      const float bright = luminance(light[i]);
      if (!(bright > 0) || chunk.hidden[k] != 0) continue;
      lit.emplace_back(bright, points.areas[i]);
      if (chunk.sky_shares[k] <= kIndoors) indoors.emplace_back(bright, points.areas[i]);
    }
  }
  const float median = weightedMedian(indoors.empty() ? lit : indoors);
  return {median > 0 ? -std::log(1 - mid_tone) / median : 0.0f};
}

}  // namespace enfilade
