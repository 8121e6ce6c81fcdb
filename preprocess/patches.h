#pragma once

#include <cstdint>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// The building's triangles in small groups that are seen or not seen together: a connected piece
/// of an object no larger than a piece of furniture, or a single triangle of a larger piece.
struct Patches {
  std::vector<std::vector<std::uint32_t>> patch_of_triangle;  ///< [object][triangle]
  std::uint32_t count = 0;
};

/// Pieces whose world box has a diagonal of at most `largest` metres stay whole.  Vertices at the
/// same place connect.
Patches makePatches(const Building& building, float largest = 1.5f);

}  // namespace enfilade
