#pragma once

#include <string>
#include <vector>

#include "models/planar_faces.h"

namespace enfilade {

inline constexpr int kOutside = -1;  ///< stands for the exterior where a room's index is asked
inline constexpr int kMasonry = -2;  ///< an area that is solid

/// What each face between the walls' centre lines is.
struct PlanAreas {
  PlanarFaces faces;
  std::vector<int> area;  ///< of each face: a room's index, kOutside or kMasonry

  int areaLeftOf(std::size_t half) const { return area[faces.halves[half].face]; }
};

/// Finds the room, or the masonry, in every area that walls enclose.  Throws Error (kBadInput) as
/// tracePlanarFaces does; for rooms in no area, or two in one; for an area with neither room nor
/// "solid".
PlanAreas findAreas(const PlanStorey& plan, const std::string& subject);

/// A room's name, "exterior" or "masonry".
std::string areaName(const PlanStorey& plan, int area);

}  // namespace enfilade
