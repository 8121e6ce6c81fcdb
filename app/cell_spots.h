#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/walk_ground.h"
#include "preprocess/tour_ground.h"

namespace enfilade {

/// Of each spot whether one can walk from it and it is part of a floor: with clearance, and in a
/// connected part that holds a good share of its cell's spots, as tables and wardrobes don't.
std::vector<std::uint8_t> floorSpots(const WalkGrid& grid, const std::vector<int>& parts);

/// The best spot of each cell among those on floors; of the exterior the one before the entrance of
/// the ground's part, if it has one.
std::vector<CellSpot> cellSpots(const House& house, const WalkGrid& grid, const TourGround& ground,
                                std::span<const std::uint8_t> on_floor);

/// The exterior if its spot leads to rooms, or the cell with the largest floor that has a spot, or
/// else the exterior.
CellId startCellOf(const House& house, const TourGround& ground, std::span<const CellSpot> spots);

}  // namespace enfilade
