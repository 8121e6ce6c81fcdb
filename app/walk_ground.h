#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "portals/house.h"
#include "preprocess/walk_grid.h"

namespace enfilade {

/// Where one can stand and walk in a house when all its doors are open, and what stops one at those
/// that are shut.  Never changes once it is there: many may use it, from any thread.
class WalkGround {
 public:
  /// Where one sees most of a cell from, and looks along.
  struct CellSpot {
    SpotId spot = kNoSpot;  ///< kNoSpot: nobody can stand in the cell
    glm::vec3 eye{0};       ///< without a spot: the middle of the cell
    float yaw = 0;          ///< [rad] toward the largest portal that is not too near, or along the
                            ///< cell's longer side
  };

  /// What a shut door takes of the floor: upright, convex.
  struct Barrier {
    PortalId portal = 0;
    std::vector<glm::vec2> outline;  ///< x and z [m], counter-clockwise from above or not
    float bottom = 0, top = 0;       ///< [m]
    glm::vec2 least{0}, most{0};     ///< of the outline
    glm::vec2 a{0}, b{0};            ///< the portal's own line, which nobody crosses
  };

  /// Takes a second or so for a large building.  `house` must outlive it, and its doors may be
  /// moved meanwhile.  A building without a floor has no spots.
  explicit WalkGround(const House& house);

  const House& house() const noexcept { return house_; }
  const WalkGrid& grid() const noexcept { return grid_; }
  const std::vector<std::string>& notes() const noexcept { return notes_; }

  /// Where a walk begins: before the entrance, or in the largest room.
  const CellSpot& start() const noexcept { return start_; }
  const CellSpot& cellSpot(CellId cell) const noexcept { return spots_[cell]; }

  /// The nearest spot to an eye, one in the same storey and room before others, and one on a floor
  /// before one on a table; kNoSpot if there is none at all.
  SpotId nearestSpot(const glm::vec3& eye) const;

  /// How far from walls and drops a point on the floor of `spot` is [m], smooth between spots.
  float clearanceAt(SpotId spot, const glm::vec2& at) const noexcept;

  /// The floor's height around a spot, stairs as a slope [m].
  float smoothFloor(SpotId spot) const noexcept;

  const std::vector<Barrier>& barriers() const noexcept { return barriers_; }
  const Box& flightBounds() const noexcept { return flight_; }  ///< nobody flies farther

 private:
  const House& house_;
  std::vector<std::string> notes_;
  WalkGrid grid_;
  std::vector<std::uint8_t> on_floor_;  ///< of each spot: it is no table's top
  std::vector<CellSpot> spots_;         ///< one a cell
  CellSpot start_;
  std::vector<Barrier> barriers_;
  Box flight_;
};

}  // namespace enfilade
