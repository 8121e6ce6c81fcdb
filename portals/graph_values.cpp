#include "portals/graph_values.h"

#include "portals/house_names.h"

namespace enfilade {

PortalKind readPortalKind(const JsonValue& value) {
  const std::string text = value.string();
  for (const auto& [kind, name] : kPortalKindNames) {
    if (text == name) return kind;
  }
  value.fail("is '" + text + "', not a kind of portal");
}

std::vector<glm::vec3> readPolygon(const JsonValue& value) {
  if (value.size() < 3) value.fail("has fewer than three corners");
  std::vector<glm::vec3> polygon;
  for (std::size_t i = 0; i < value.size(); ++i) polygon.push_back(value.at(i).vector());
  return polygon;
}

}  // namespace enfilade
