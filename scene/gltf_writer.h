#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// The GLB of `building`: a primitive for each of our meshes (those of one node together in one
/// glTF mesh), vertex arrays shared as accessors, nodes with their hierarchy, node extras under
/// `extras.enfilade`, lights (one a node).  Numbers that several arrays share are written once.
/// Images keep their own bytes.  Reading it again gives the same nodes, objects and materials in
/// the same order.  Meshes that no object places are left out; those that one does must have
/// triangles.  The same bytes for the same building.  Throws Error (kMachine): more than 4 GiB.
std::vector<std::uint8_t> encodeGlb(const Building& building);

/// Writes encodeGlb's bytes by way of a temporary name.  Throws Error (kMachine).
void writeGlb(const std::string& file, const Building& building);

}  // namespace enfilade
