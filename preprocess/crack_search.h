#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "preprocess/sight_claims.h"

namespace enfilade {

/// The first of the lines for each place, to a voxel, where a cell is left; thinned evenly if they
/// are more than `most`.
std::vector<CrackLine> oneOfEachPlace(std::vector<CrackLine> lines, float voxel,
                                      std::size_t most = std::numeric_limits<std::size_t>::max());

/// Cracks narrower than a voxel show cells what chance finds but rarely.  So where one sight line
/// passed one and met something new, more go through the same place from elsewhere in the cell; and
/// again from what these find, until nothing new comes.
/// `lines`: the first ones, in an order that is the same run after run.  Adds to `claims`, which
/// must be sorted and united, and leaves them so.  The same claims for any number of threads.
/// Source: Wonka et al., Guided Visibility Sampling, 2006.
void searchCracks(const SightClaims& sight, std::vector<CrackLine> lines, PatchCells& claims);

}  // namespace enfilade
