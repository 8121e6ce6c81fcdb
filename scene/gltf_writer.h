#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// The GLB of `building`: one glTF mesh with one primitive for each of our meshes, vertex arrays
/// shared as accessors, a flat list of nodes each with its world transform (parents kept where the
/// node hierarchy has them), node extras under `extras.enfilade`.  Reading it again gives the same
/// objects in the same order.  The same bytes for the same building.
std::vector<std::uint8_t> encodeGlb(const Building& building);

/// Writes encodeGlb's bytes by way of a temporary name.  Throws Error (kMachine).
void writeGlb(const std::string& file, const Building& building);

}  // namespace enfilade
