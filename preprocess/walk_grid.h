#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "portals/house.h"
#include "preprocess/walk_columns.h"

namespace enfilade {

/// A place to stand, in one column of a WalkGrid.
using SpotId = std::uint32_t;
inline constexpr SpotId kNoSpot = 0xffffffffu;

/// What a walker's body can do.
struct WalkLimits {
  float step_height = 0.35f;  ///< [m] [> 0] the highest step that is climbed
  float head_room = 1.8f;     ///< [m] [> 0]
  float eye_height = 1.6f;    ///< [m] [> 0] above the floor
};

/// All places in a building where one can stand, several above each other in a column where there
/// are storeys or stairs, and which of them one step joins.
struct WalkGrid {
  WalkLimits limits;
  glm::vec2 origin{0};  ///< least corner, x and z [m]
  float pitch = 0.05f;  ///< edge of a column [m]
  glm::ivec2 size{0};   ///< columns along x and along z

  std::vector<std::uint32_t> first;   ///< a column's first spot; one more entry than columns
  std::vector<std::uint32_t> column;  ///< of each spot: index x · size.y + z
  std::vector<float> floor;           ///< of each spot [m]
  std::vector<float> ceiling;         ///< of each spot [m]; infinite under the sky
  std::vector<float> clearance;  ///< of each spot [m]: to the nearest place where none can stand
  std::vector<std::array<SpotId, 4>> links;  ///< of each spot: one step along +x, +z, −x, −z
  std::vector<CellId> cell;  ///< of each spot: where its eye is; kNoCell where too narrow

  std::vector<std::uint8_t>
      joined;  ///< cells × cells: 1 where a portal that stands open joins them
  std::size_t cell_count = 0;

  std::size_t spotCount() const noexcept { return column.size(); }
  glm::ivec2 columnOf(SpotId spot) const noexcept;
  glm::ivec2 columnAt(const glm::vec2& p) const noexcept;  ///< may lie outside the grid
  glm::vec2 centerOf(SpotId spot) const noexcept;          ///< x and z [m]
  glm::vec3 eyeOf(SpotId spot) const noexcept;

  /// The spot that one step in direction 0…7 reaches (0 is +x, counting toward +z; odd ones are
  /// diagonal and need both straight ways around the corner), or kNoSpot: nothing there to stand
  /// on, too high, too low overhead, or in a cell that no portal joins to this one.
  SpotId neighbour(SpotId spot, int direction) const noexcept;

  /// The spot in `column` that one step of at most `step` joins to `spot`, whatever the cells.
  SpotId spotInColumn(SpotId spot, const glm::ivec2& target, float step) const noexcept;

  bool mayPass(CellId a, CellId b) const noexcept {
    return a == b || a == kNoCell || b == kNoCell || joined[a * cell_count + b] != 0;
  }
};

/// The eight directions of WalkGrid::neighbour.
inline constexpr int kDirections[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                          {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

/// No closer than this to where none can stand does any part of a tour go [m].
inline constexpr float kNarrowestClearance = 0.12f;

/// Finds the spots, their clearance and their cells.  Gaps in the floor of up to 0.4 m are stepped
/// over.  Where `ground` is a number [m],
/// the exterior has a floor at that height, under whatever floors are there.
/// Source: filtering and distance field as in Mononen's Recast.
WalkGrid buildWalkGrid(const House& house, const WalkColumns& columns, const WalkLimits& limits,
                       DoorsStand doors = DoorsStand::kAsTheyAre,
                       float ground = std::numeric_limits<float>::quiet_NaN());

}  // namespace enfilade
