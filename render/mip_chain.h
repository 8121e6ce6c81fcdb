#pragma once

#include <vector>

#include "scene/image.h"

namespace enfilade {

/// The pictures of half, quarter … size of `image` down to 1 × 1 (sizes rounded down), the image
/// itself not among them.  Each texel is the mean, weighted by area and by alpha, of the stored
/// values it covers; nothing is decoded, as the shading does not either (shading.h).
std::vector<Image> mipChain(const Image& image);

}  // namespace enfilade
