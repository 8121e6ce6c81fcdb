#pragma once

#include "scene/building.h"

namespace enfilade {

/// Whether every edge of the mesh joins an even number of its triangles, corners at the same place
/// taken as one and triangles without area left out: the mesh bounds a solid, it has no border.
bool isClosed(const Building& building, const Mesh& mesh);

}  // namespace enfilade
