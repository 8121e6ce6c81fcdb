#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "portals/house.h"

namespace enfilade {

using WorldTriangle = std::array<glm::vec3, 3>;

/// Which doors a walker finds open.
enum class DoorsStand : std::uint8_t {
  kAsTheyAre,  ///< all but those whose portals are shut
  kAllOpen,
};

/// Calls `visit` with every triangle, in the world, that a walker cannot pass: all but open doors.
/// In increasing order of object, then of triangle; corners that are no numbers are left out.
void forEachObstacle(const House& house, DoorsStand doors,
                     const std::function<void(const WorldTriangle&)>& visit);

/// A stretch of a column that surfaces fill.
struct SolidSpan {
  float bottom = 0;    ///< [m]
  float top = 0;       ///< [m] ≥ bottom
  bool steep = false;  ///< the top is too steep to stand on
};

/// Upright square columns over a building's ground, each with the stretches that surfaces fill.
struct WalkColumns {
  glm::vec2 origin{0};  ///< least corner, x and z [m]
  float pitch = 0.05f;  ///< edge of a column [m]
  glm::ivec2 size{0};   ///< columns along x and along z
  std::vector<std::vector<SolidSpan>>
      spans;  ///< index x · size.y + z; disjoint, lowest first, exact along y

  std::size_t index(const glm::ivec2& c) const noexcept {
    return static_cast<std::size_t>(c.x) * static_cast<std::size_t>(size.y) +
           static_cast<std::size_t>(c.y);
  }
  bool contains(const glm::ivec2& c) const noexcept {
    return c.x >= 0 && c.y >= 0 && c.x < size.x && c.y < size.y;
  }
};

/// Clips every obstacle triangle to the columns that it touches, over the ground of `bounds`.
/// Slopes of more than 50 degrees, walls aside, are too steep. Source: the solid heightfield of
/// Mononen's Recast (rcRasterizeTriangles).
WalkColumns rasteriseColumns(const House& house, float pitch, const Box& bounds,
                             DoorsStand doors = DoorsStand::kAsTheyAre);

}  // namespace enfilade
