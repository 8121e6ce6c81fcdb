#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "preprocess/light_parameters.h"
#include "preprocess/light_points.h"
#include "preprocess/light_sides.h"
#include "render/light_rays.h"

namespace enfilade {

/// What some points in a row receive, and from which points the rest comes.  Illuminance in lux.
struct LightChunk {
  /// A point seen through a sky portal.
  struct FarLink {
    std::uint32_t point;
    float weight;  ///< of its light, over π
  };
  std::size_t first = 0;                 ///< of the points
  std::vector<glm::vec3> direct;         ///< one a point: from sky and lamps [lx]
  std::vector<float> shares;             ///< one a point: of each of its links
  std::vector<float> sky_shares;         ///< one a point: of all directions, the sky's
  std::vector<std::uint8_t> hidden;      ///< one a point: in a wall, or stood upon
  std::vector<std::uint32_t> links_end;  ///< one a point, in `links`
  std::vector<std::uint32_t> links;      ///< points
  std::vector<std::uint32_t> far_end;    ///< one a point, in `far`
  std::vector<FarLink> far;
};

/// All that rays can tell, once: every bounce of light is then a look-up.
struct GatheredLight {
  std::vector<LightChunk> chunks;
  std::size_t rays = 0;
  std::size_t links = 0;
};

/// Traces from every point.  The same for any number of threads.  `tell`: the share done.
/// Source: links as in Hanrahan, Salzman & Aupperle, A Rapid Hierarchical Radiosity Algorithm,
/// 1991, drawn by rays over the cosine instead of being refined.
GatheredLight gatherLight(const Building& building, const LightPoints& points,
                          const LightSides& sides, const LightRays& rays,
                          std::span<const SkyPortal> portals, const LightParameters& parameters,
                          const std::function<void(double)>& tell);

}  // namespace enfilade
