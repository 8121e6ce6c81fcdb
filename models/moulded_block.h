#pragma once

#include <vector>

#include "models/mesh_builder.h"

namespace enfilade {

/// A point of a moulding's profile: how far it stands out, its height [m], its shade 0…1.
struct MouldingPoint {
  double out, y, shade;
};

/// A block around the y axis, 2 · `half` (x, z) wide plus the profile's `out` on every side, its
/// top the profile's last point; open below.
void raiseMouldedBlock(const glm::dvec2& half, const std::vector<MouldingPoint>& profile,
                       double texture_size, MeshBuilder& mesh);

}  // namespace enfilade
