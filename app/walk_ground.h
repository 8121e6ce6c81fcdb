#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/walk_barriers.h"
#include "preprocess/walk_grid.h"

namespace enfilade {

/// Where one sees most of a cell from.
struct CellSpot {
  SpotId spot = kNoSpot;  ///< kNoSpot: nobody can stand in the cell
  glm::vec3 eye{0};       ///< [m] without a spot: somewhere in the cell, by its middle
  float yaw = 0;          ///< [rad] toward the largest portal that is not too near, or along the
                          ///< cell's longer side; from outside toward the entrance
};

/// Where one can stand and walk in a house when all its doors are open, and what those that are
/// shut take of it.  Never changes once it is there: many may use it, from any thread.
class WalkGround {
 public:
  /// `house` must outlive it; its doors may be moved meanwhile.  Without a floor there are no
  /// spots.
  explicit WalkGround(const House& house);

  const House& house() const noexcept { return house_; }
  const WalkGrid& grid() const noexcept { return grid_; }
  const std::vector<std::string>& notes() const noexcept { return notes_; }
  const std::vector<WalkBarrier>& barriers() const noexcept { return barriers_; }  ///< one a portal
  const Box& flightBounds() const noexcept { return flight_; }  ///< nobody flies farther

  const CellSpot& cellSpot(CellId cell) const noexcept { return spots_[cell]; }
  /// The cell where a walk begins: the exterior, before the entrance, or the largest room.
  CellId startCell() const noexcept { return start_; }

  /// The nearest spot to an eye, one in its room before others, and one on a floor before one on a
  /// table; kNoSpot if there is none at all.
  SpotId nearestSpot(const glm::vec3& eye) const;

  /// The spot that holds `to`, at most a column from `spot`, or kNoSpot: no step leads there, or it
  /// is too near a wall or a drop.
  SpotId stepTo(SpotId spot, const glm::vec2& to) const noexcept;

  /// How far `at`, a column from `spot` at most, is from walls and drops [m]: smooth.
  float clearanceAt(SpotId spot, const glm::vec2& at) const noexcept;

  /// The floor's height around a spot, stairs as a slope [m].
  float smoothFloor(SpotId spot) const noexcept;

 private:
  const House& house_;
  std::vector<std::string> notes_;
  WalkGrid grid_;
  std::vector<std::uint8_t> on_floor_;  ///< of each spot: it can be walked from, and is no table's
  std::vector<CellSpot> spots_;         ///< one a cell
  CellId start_ = kExterior;
  std::vector<WalkBarrier> barriers_;
  Box flight_;
};

}  // namespace enfilade
