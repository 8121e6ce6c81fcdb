#pragma once

#include <cstdint>
#include <vector>

#include "ibr/capture_samples.h"

namespace enfilade {

/// The samples of a picture block by block, with a border of empty blocks all around.
struct BlockGrid {
  std::size_t stride = 0;  ///< blocks in a row, border included
  std::vector<CaptureSample> samples;
  std::vector<std::uint32_t> first;  ///< block i holds samples [first[i], first[i + 1])
};

/// The surfaces seen in every block of `rays` × `rays` pixels, as resolveCapture() says, without
/// their slopes.
BlockGrid gridOfBlocks(const DepthImage& fine, int rays, float threshold);

}  // namespace enfilade
