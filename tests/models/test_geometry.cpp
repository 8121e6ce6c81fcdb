#include "tests/models/test_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "models/embedded_plans.h"
#include "models/floor_plan.h"
#include "models/raise_building.h"

namespace enfilade {

Building unpaintedGallery(std::uint64_t triangles) {
  const auto plans = embeddedPlans();
  const auto gallery = std::find_if(plans.begin(), plans.end(), [](const EmbeddedPlan& plan) {
    return std::string_view(plan.name) == "gallery";
  });
  FloorPlan plan = parseFloorPlan(gallery->text, "gallery");
  for (auto& [name, finish] : plan.finishes) finish.pattern = "plain";
  return raiseBuilding(plan, triangles, "gallery");
}

bool isMarker(const Building& building, const Object& object) {
  const std::string& name = building.nodes[object.node].name;
  return name.find("-portal") != std::string::npos || name.find("-bound") != std::string::npos;
}

std::string rootName(const Building& building, const Object& object) {
  std::uint32_t node = object.node;
  while (building.nodes[node].parent != kNone) node = building.nodes[node].parent;
  return building.nodes[node].name;
}

double rayMeets(const glm::dvec3& origin, const glm::dvec3& direction, const WorldTriangle& t) {
  const glm::dvec3 a(t.a), e1 = glm::dvec3(t.b) - a, e2 = glm::dvec3(t.c) - a;
  const glm::dvec3 p = glm::cross(direction, e2);
  const double det = glm::dot(e1, p);
  if (std::abs(det) < 1e-14) return -1;
  const glm::dvec3 s = origin - a;
  const double u = glm::dot(s, p) / det;
  if (u < 0 || u > 1) return -1;
  const glm::dvec3 q = glm::cross(s, e1);
  const double v = glm::dot(direction, q) / det;
  if (v < 0 || u + v > 1) return -1;
  return glm::dot(e2, q) / det;
}

std::vector<NamedPortal> namedPortals(const Building& building) {
  std::vector<NamedPortal> portals;
  for (const Object& object : building.objects) {
    const Node& node = building.nodes[object.node];
    if (node.name.find("-portal") == std::string::npos) continue;
    const auto json = nlohmann::json::parse(node.extras).at("portal");
    NamedPortal portal{
        node.name, building.nodes[node.parent].name, json.at("to"), json.at("kind"), {}};
    const auto& positions = building.vertex_arrays[building.meshOf(object).vertices].positions;
    EXPECT_EQ(positions.size(), 4u) << node.name;
    for (std::size_t i = 0; i < 4; ++i) portal.corners[i] = positions[i];
    portals.push_back(portal);
  }
  return portals;
}

}  // namespace enfilade
