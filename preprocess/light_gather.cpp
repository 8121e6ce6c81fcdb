#include "preprocess/light_gather.h"

#include <algorithm>
#include <mutex>

#include "preprocess/light_lamps.h"
#include "preprocess/light_samples.h"
#include "preprocess/light_windows.h"
#include "preprocess/work_crew.h"

namespace enfilade {
namespace {

constexpr std::size_t kTogether = 1024;  // points
constexpr float kOffset = 0.002f;        // of a ray's origin above its face [m]
constexpr float kFarAway = 1e4f;         // [m]
constexpr float kInsideWalls = 0.2f;     // nearer back faces are those of the wall itself [m]
constexpr float kSeenFromBehind = 0.3f;  // cosine: beyond what smooth normals can be off
constexpr float kStoodUpon = 0.05f;      // mean way of a large face's rays [m]

/// How many rays the points have, so that their links keep within bounds.
struct RayCounts {
  int large, detail;
};

RayCounts rayCounts(const LightPoints& points, const LightParameters& parameters) {
  const auto large = static_cast<double>(std::count(points.large.begin(), points.large.end(), 1));
  const double all = large * parameters.rays +
                     (static_cast<double>(points.size()) - large) * parameters.detail_rays;
  const double fit = std::min(1.0, static_cast<double>(parameters.most_links) / std::max(all, 1.0));
  return {std::max(1, static_cast<int>(parameters.rays * fit)),
          std::max(1, static_cast<int>(parameters.detail_rays * fit))};
}

class Gatherer {
 public:
  Gatherer(const Building& building, const LightPoints& points, const LightSides& sides,
           const LightRays& rays, std::span<const SkyPortal> portals,
           const LightParameters& parameters)
      : points_(points),
        sides_(sides),
        rays_(rays),
        parameters_(parameters),
        lamps_(building, rays),
        windows_(portals, rays),
        counts_(rayCounts(points, parameters)),
        large_(lightSamples(counts_.large)),
        detail_(lightSamples(counts_.detail)) {}

  std::size_t raysFrom(std::size_t point) const {
    return points_.large[point] != 0 ? large_.size() : detail_.size();
  }

  void gather(std::size_t first, LightChunk& chunk) const {
    chunk.first = first;
    for (std::size_t i = first; i < std::min(first + kTogether, points_.size()); ++i) {
      const glm::vec3 origin = points_.positions[i] + kOffset * sides_.normals[i];
      gatherAround(i, origin, chunk);
      chunk.links_end.push_back(static_cast<std::uint32_t>(chunk.links.size()));
      chunk.direct.back() += lamps_.at(origin, sides_.normals[i]);
      lookThroughWindows(i, origin, chunk);
      chunk.far_end.push_back(static_cast<std::uint32_t>(chunk.far.size()));
    }
    chunk.links.shrink_to_fit();
    chunk.far.shrink_to_fit();
  }

 private:
  /// Which point lights a ray that met `hit`: one of the triangle's three, as near as it is.
  std::uint32_t pointMet(const LightHit& hit, float pick) const {
    const WorldGeometry& world = rays_.surfaces().world();
    const std::uint32_t* corners =
        &world.indices[world.objects[hit.object].first + 3 * std::size_t{hit.triangle}];
    const int k = pick < hit.u ? 1 : pick < hit.u + hit.v ? 2 : 0;
    return points_.of_vertex[corners[k]];
  }

  /// kNone if the ray met a side that no light comes to.
  std::uint32_t litPoint(const LightHit& hit, const glm::vec3& direction, float pick) const {
    if (hit.back && !rays_.surfaces().material(hit.object).double_sided) return kNone;
    const std::uint32_t point = pointMet(hit, pick);
    const bool behind = glm::dot(direction, sides_.normals[point]) > kSeenFromBehind;
    return behind && sides_.thin[point] == 0 ? kNone : point;
  }

  bool isInsideWall(const LightHit& hit) const {
    return hit.back && hit.object != kNone && hit.distance < kInsideWalls &&
           !rays_.surfaces().material(hit.object).double_sided;
  }

  void gatherAround(std::size_t i, const glm::vec3& origin, LightChunk& chunk) const {
    const bool large = points_.large[i] != 0;
    const std::vector<LightSample>& samples = large ? large_ : detail_;
    const glm::mat3 frame = frameAround(sides_.normals[i]);
    glm::vec3 sky(0);
    float way = 0;
    int counted = 0, free = 0;
    for (const LightSample& sample : samples) {
      const glm::vec3 direction = frame * sample.direction;
      const LightHit hit = rays_.trace(origin, direction, 0, kFarAway, sample.chance, true);
      if (isInsideWall(hit)) continue;
      ++counted;
      way += hit.distance < 0 ? 1.0f : std::min(hit.distance, 1.0f);
      if (hit.distance < 0) {
        sky += parameters_.sky.along(direction);
        ++free;
      } else if (hit.object != kNone) {
        const std::uint32_t lit = litPoint(hit, direction, sample.pick);
        if (lit != kNone) chunk.links.push_back(lit);
      }
    }
    const float share = counted > 0 ? 1.0f / static_cast<float>(counted) : 0.0f;
    const bool in_wall = 2 * static_cast<std::size_t>(counted) < samples.size();
    chunk.direct.push_back(sky * share * glm::pi<float>());
    chunk.shares.push_back(share);
    chunk.sky_shares.push_back(static_cast<float>(free) * share);
    chunk.hidden.push_back(in_wall || (large && way * share < kStoodUpon) ? 1 : 0);
  }

  void lookThroughWindows(std::size_t i, const glm::vec3& origin, LightChunk& chunk) const {
    const int count =
        points_.large[i] != 0 ? parameters_.sky_samples : parameters_.detail_sky_samples;
    windows_.sample(origin, sides_.normals[i], count, [&](const WindowView& view) {
      if (view.hit.distance < 0) {
        chunk.direct.back() += view.weight * view.passed * parameters_.sky.along(view.direction);
        return;
      }
      const std::uint32_t lit = litPoint(view.hit, view.direction, view.pick);
      const float passed = (view.passed.r + view.passed.g + view.passed.b) / 3;
      if (lit != kNone) chunk.far.push_back({lit, view.weight * passed / glm::pi<float>()});
    });
  }

  const LightPoints& points_;
  const LightSides& sides_;
  const LightRays& rays_;
  const LightParameters& parameters_;
  const Lamps lamps_;
  const Windows windows_;
  const RayCounts counts_;
  const std::vector<LightSample> large_, detail_;
};

}  // namespace

GatheredLight gatherLight(const Building& building, const LightPoints& points,
                          const LightSides& sides, const LightRays& rays,
                          std::span<const SkyPortal> portals, const LightParameters& parameters,
                          const std::function<void(double)>& tell) {
  const Gatherer gatherer(building, points, sides, rays, portals, parameters);
  GatheredLight light;
  light.chunks.resize((points.size() + kTogether - 1) / kTogether);
  std::mutex telling;
  std::size_t done = 0;
  shareOutJobs(light.chunks.size(), parameters.threads, [&]() -> Worker {
    return [&](std::size_t c) {
      gatherer.gather(c * kTogether, light.chunks[c]);
      const std::lock_guard lock(telling);
      ++done;
      if (tell) tell(static_cast<double>(done) / static_cast<double>(light.chunks.size()));
    };
  });
  for (const LightChunk& chunk : light.chunks) light.links += chunk.links.size() + chunk.far.size();
  for (std::size_t i = 0; i < points.size(); ++i) light.rays += gatherer.raysFrom(i);
  return light;
}

}  // namespace enfilade
