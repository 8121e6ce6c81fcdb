#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "portals/cell_graph.h"
#include "portals/json_value.h"

namespace enfilade {

/// Parts of a portal in JSON.  Both throw Error (kBadInput) as JsonValue does.
PortalKind readPortalKind(const JsonValue& value);
std::vector<glm::vec3> readPolygon(const JsonValue& value);  ///< at least three corners

}  // namespace enfilade
