#include "portals/portal_names.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <sstream>

namespace enfilade {

std::vector<PortalId> portalsNamed(const CellGraph& graph, const std::string& names) {
  std::vector<std::string> patterns;
  std::istringstream stream(names);
  for (std::string pattern; std::getline(stream, pattern, ',');) patterns.push_back(pattern);
  std::vector<PortalId> portals;
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    const std::string& name = graph.portals[id].name;
    for (const std::string& pattern : patterns) {
      if (pattern != fmt::format("{}", id) && pattern != name &&
          fnmatch(pattern.c_str(), name.c_str(), 0) != 0) {
        continue;
      }
      portals.push_back(id);
      break;
    }
  }
  return portals;
}

}  // namespace enfilade
