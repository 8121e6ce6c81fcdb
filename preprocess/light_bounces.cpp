#include "preprocess/light_bounces.h"

#include "preprocess/hidden_points.h"
#include "preprocess/work_crew.h"

namespace enfilade {
namespace {

/// What one chunk's points receive if every point sends out `sent`.
void receive(const LightChunk& chunk, const std::vector<glm::vec3>& sent,
             std::vector<glm::vec3>& light) {
  std::size_t link = 0, far = 0;
  for (std::size_t i = 0; i < chunk.direct.size(); ++i) {
    glm::vec3 near_sum(0), far_sum(0);
    for (; link < chunk.links_end[i]; ++link) near_sum += sent[chunk.links[link]];
    for (; far < chunk.far_end[i]; ++far) {
      far_sum += chunk.far[far].weight * sent[chunk.far[far].point];
    }
    light[chunk.first + i] = chunk.direct[i] + chunk.shares[i] * near_sum + far_sum;
  }
}

}  // namespace

std::vector<glm::vec3> bounceLight(const LightPoints& points, const WorldGeometry& world,
                                   const GatheredLight& gathered, int bounces, int threads) {
  std::vector<glm::vec3> light(points.size()), sent(points.size());
  const HiddenPoints hidden(points, world, gathered);
  for (const LightChunk& chunk : gathered.chunks) {
    std::copy(chunk.direct.begin(), chunk.direct.end(),
              light.begin() + static_cast<std::ptrdiff_t>(chunk.first));
  }
  hidden.fill(light);
  for (int bounce = 0; bounce < bounces; ++bounce) {
    for (std::size_t i = 0; i < points.size(); ++i) sent[i] = points.albedos[i] * light[i];
    shareOutJobs(gathered.chunks.size(), threads, [&]() -> Worker {
      return [&](std::size_t c) { receive(gathered.chunks[c], sent, light); };
    });
    hidden.fill(light);
  }
  return light;
}

}  // namespace enfilade
