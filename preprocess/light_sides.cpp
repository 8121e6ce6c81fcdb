#include "preprocess/light_sides.h"

#include <algorithm>

#include "preprocess/light_samples.h"
#include "preprocess/work_crew.h"

namespace enfilade {
namespace {

constexpr int kProbes = 12;
constexpr float kFarEnough = 1.0f;  // a probe that gets this far is as good as free [m]
constexpr float kOffset = 0.002f;   // above the face [m]
constexpr float kAsOpen = 0.6f;     // of the other side: both are open
constexpr std::size_t kTogether = 4096;

/// How far one gets from a point to one side, on average [m], at most kFarEnough.
float openness(const LightRays& rays, const std::vector<LightSample>& probes,
               const glm::vec3& position, const glm::vec3& normal) {
  const glm::mat3 frame = frameAround(normal);
  float sum = 0;
  for (const LightSample& probe : probes) {
    const LightHit hit = rays.trace(position + kOffset * normal, frame * probe.direction, 0,
                                    kFarEnough, probe.chance, false);
    sum += hit.distance < 0 ? kFarEnough : hit.distance;
  }
  return sum / static_cast<float>(probes.size());
}

}  // namespace

LightSides chooseSides(const Building& building, const LightPoints& points, const LightRays& rays,
                       int threads) {
  LightSides sides{points.normals, std::vector<std::uint8_t>(points.size(), 0)};
  const std::vector<LightSample> probes = lightSamples(kProbes);
  const auto choose = [&](std::size_t i) {
    if (!building.materialOf(building.objects[points.objects[i]]).double_sided) return;
    const float front = openness(rays, probes, points.positions[i], points.normals[i]);
    const float back = openness(rays, probes, points.positions[i], -points.normals[i]);
    if (back > 1.2f * front) sides.normals[i] = -points.normals[i];
    sides.thin[i] = std::min(front, back) > kAsOpen * std::max(front, back) ? 1 : 0;
  };
  shareOutJobs((points.size() + kTogether - 1) / kTogether, threads, [&]() -> Worker {
    return [&](std::size_t part) {
      const std::size_t end = std::min((part + 1) * kTogether, points.size());
      for (std::size_t i = part * kTogether; i < end; ++i) choose(i);
    };
  });
  return sides;
}

}  // namespace enfilade
