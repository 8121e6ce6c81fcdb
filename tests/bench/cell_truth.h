#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "preprocess/authored_names.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// A room of the truth: spaces with nothing but virtual boundaries between them are one.
struct TrueRoom {
  std::string name;
  std::vector<std::pair<int, int>> columns;  ///< of the grid
  float slice_y = 0;
  int cell = -1;  ///< best match, by index in the graph; −1 none
  float iou = 0;
};

/// A door, window or unfilled opening.
struct TrueOpening {
  std::string name, kind;
  glm::vec3 center{0}, normal{0};
  float width = 0, height = 0;       ///< [m]
  std::array<int, 2> rooms{-1, -1};  ///< index in rooms; −1 outside, or in no room
  bool rooms_known = true;           ///< false: the truth says nothing of rooms
};

/// What a building's author says of it.
struct Truth {
  std::vector<TrueRoom> rooms;
  std::map<std::string, int> room_of_space;
  std::vector<TrueOpening> openings;
};

/// Reads NAME.semantics.json: rooms as columns of `grid` at 1.2 m above their floor.  Of a game
/// map the doors alone: its sectors are no rooms.  `turned`: what was done to the building.
Truth readTruth(const std::string& file, const VoxelGrid& grid, const glm::mat3& turned);

/// The cells and portals that the author of a model named in it.
Truth authoredTruth(const AuthoredNames& names, const VoxelGrid& grid);

}  // namespace enfilade
