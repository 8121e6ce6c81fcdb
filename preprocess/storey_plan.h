#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/storey_slice.h"
#include "preprocess/watershed.h"

namespace enfilade {

/// A basin of a storey's plan, and what it borders on.
struct PlanBasin {
  enum class Use : std::uint8_t { kRoom, kOutside, kTooSmall };

  Use use = Use::kRoom;
  int area = 0;              ///< [pixels]
  int open_to_sky = 0;       ///< [pixels]
  bool at_border = false;    ///< of the grid
  int border = 0;            ///< [pixel edges] its outline
  int walled = 0;            ///< [pixel edges] of these, along walls, lintels, doors and glass
  int openings = 0;          ///< [pixel edges] of these, along anything but walls
  int to_exterior = 0;       ///< [pixel edges] of these, open to basins of the exterior
  std::int32_t ceiling = 0;  ///< [voxel] columns open to the sky are taken to end here
};

/// A storey's rooms and exterior in plan.
struct StoreyPlan {
  StoreyBand band;
  StoreySlice slice;
  Basins basins;
  std::vector<PlanBasin> uses;  ///< one a basin
};

StoreyPlan planStorey(const VoxelGrid& voxels, const StoreyBand& band,
                      const CellParameters& parameters);

/// Whether hardly any enclosed basin has a roof.
bool isRoofless(const VoxelGrid& voxels, const std::vector<StoreyPlan>& plans);

/// A basin that would be a room if smaller ones were.
struct SmallRoom {
  glm::vec2 at{0};  ///< [m] x and z of its middle
  float area = 0;   ///< [m²]
  float width = 0;  ///< [m]
};

/// Basins that are too small or too narrow to be rooms but no mere niches or hollow walls: at least
/// 0.45 m² and 0.3 m wide, half of it within walls, not all.  Largest first.
std::vector<SmallRoom> smallRooms(const VoxelGrid& voxels, const StoreyPlan& plan);

/// Two parts of one room that a higher merge ratio would part.
struct WideNeck {
  glm::vec2 at{0};        ///< [m] x and z of its middle
  float width = 0;        ///< [m]
  float area = 0;         ///< [m²] of the smaller part at least
  float least_ratio = 0;  ///< CellParameters::merge_ratio from which on they are two rooms
};

/// The necks within rooms that are clearly narrower than either part, each of which is large enough
/// to be a room; those nearest to parting first.
std::vector<WideNeck> wideNecks(const VoxelGrid& voxels, const CellParameters& parameters,
                                const StoreyPlan& plan);

/// Decides what is exterior and what is too small to be a room, and sets the ceilings.  Returns the
/// number of porches that went to the exterior.
int classifyBasins(const VoxelGrid& voxels, const CellParameters& parameters, bool roofless,
                   StoreyPlan& plan);

}  // namespace enfilade
