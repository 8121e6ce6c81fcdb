#pragma once

#include <string>
#include <vector>

#include "portals/cell_graph.h"

namespace enfilade {

/// The portals that `names` means, increasing: numbers, names, and patterns with * and ?, joined by
/// commas.
std::vector<PortalId> portalsNamed(const CellGraph& graph, const std::string& names);

}  // namespace enfilade
