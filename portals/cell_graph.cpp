#include "portals/cell_graph.h"

#include <fmt/format.h>

#include <cmath>

namespace enfilade {

namespace {

constexpr float kPlanarTolerance = 0.01f;  // [m] corners off their plane, corners bent inwards
constexpr float kLeastArea = 1e-6f;        // [m²]
constexpr float kNormalTolerance = 1e-3f;

/// Twice the area, along the normal (Newell's method), in double precision about the first corner.
glm::dvec3 newellSum(const std::vector<glm::vec3>& polygon) {
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(glm::dvec3(polygon[i]) - glm::dvec3(polygon[0]),
                      glm::dvec3(polygon[i + 1]) - glm::dvec3(polygon[0]));
  }
  return sum;
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isPlanar(const Portal& portal) {
  for (const glm::vec3& corner : portal.polygon) {
    if (!(std::abs(portal.plane.signedDistance(corner)) <= kPlanarTolerance)) return false;
  }
  return true;
}

/// Every corner on the inner side of every edge, or within the tolerance of it.
bool isConvex(const Portal& portal) {
  const std::size_t count = portal.polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3& a = portal.polygon[i];
    const glm::vec3 edge = portal.polygon[(i + 1) % count] - a;
    const float length = glm::length(edge);
    if (length == 0) continue;
    const glm::vec3 inward = glm::cross(portal.plane.normal, edge / length);
    for (const glm::vec3& corner : portal.polygon) {
      if (glm::dot(corner - a, inward) < -kPlanarTolerance) return false;
    }
  }
  return true;
}

void diagnosePolygon(const Portal& portal, const std::string& who,
                     std::vector<std::string>& problems) {
  for (const glm::vec3& corner : portal.polygon) {
    if (!finite(corner)) {
      problems.push_back(who + " has a corner that is not a finite number");
      return;
    }
  }
  if (portal.polygon.size() < 3) {
    problems.push_back(fmt::format("{} has {} corners, needs 3", who, portal.polygon.size()));
    return;
  }
  if (!(portal.area() >= kLeastArea)) {
    problems.push_back(who + " has no area");
    return;
  }
  const Plane own = planeOf(portal.polygon);
  const float cosine = glm::dot(own.normal, portal.plane.normal);
  if (!(std::abs(glm::length(portal.plane.normal) - 1.0f) <= kNormalTolerance)) {
    problems.push_back(who + " has a plane whose normal is not of unit length");
  } else if (cosine < 0) {
    problems.push_back(who + " is wound against its plane");
  } else if (!isPlanar(portal)) {
    problems.push_back(fmt::format("{} is not planar within {} m", who, kPlanarTolerance));
  } else if (!isConvex(portal)) {
    problems.push_back(who + " is not convex");
  }
}

}  // namespace

glm::vec3 Portal::center() const {
  glm::dvec3 mean(0);
  for (const glm::vec3& corner : polygon) mean += glm::dvec3(corner);
  mean /= static_cast<double>(polygon.size());
  const glm::dvec3 normal = newellSum(polygon);
  const double twice_area = glm::dot(normal, normal);
  if (twice_area == 0) return glm::vec3(mean);
  // The triangles about the mean, weighted by their share of the area.
  glm::dvec3 center(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a(polygon[i]);
    const glm::dvec3 b(polygon[(i + 1) % polygon.size()]);
    const double weight = glm::dot(glm::cross(a - mean, b - mean), normal) / twice_area;
    center += weight * (mean + a + b) / 3.0;
  }
  return glm::vec3(center);
}

float Portal::area() const { return static_cast<float>(0.5 * glm::length(newellSum(polygon))); }

Plane planeOf(const std::vector<glm::vec3>& polygon) {
  const glm::dvec3 sum = newellSum(polygon);
  const double length = glm::length(sum);
  if (length == 0) return {};
  const glm::dvec3 normal = sum / length;
  glm::dvec3 mean(0);
  for (const glm::vec3& corner : polygon) mean += glm::dvec3(corner);
  mean /= static_cast<double>(polygon.size());
  return {glm::vec3(normal), static_cast<float>(-glm::dot(normal, mean))};
}

void linkCells(CellGraph& graph) {
  for (Cell& cell : graph.cells) cell.portals.clear();
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    const Portal& portal = graph.portals[id];
    if (portal.front < graph.cells.size()) graph.cells[portal.front].portals.push_back(id);
    if (portal.back < graph.cells.size() && portal.back != portal.front) {
      graph.cells[portal.back].portals.push_back(id);
    }
  }
}

std::vector<std::string> diagnose(const CellGraph& graph) {
  std::vector<std::string> problems;
  std::vector<bool> reached(graph.cells.size(), false);
  if (graph.cells.empty()) problems.push_back("the graph has no exterior cell");
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    const Portal& portal = graph.portals[id];
    const std::string who = fmt::format("portal {} '{}'", id, portal.name);
    for (const CellId cell : {portal.front, portal.back}) {
      if (cell < graph.cells.size()) {
        reached[cell] = true;
      } else {
        problems.push_back(who + " leads to a cell that does not exist");
      }
    }
    if (portal.front == portal.back) {
      problems.push_back(who + " has the same cell on both sides");
    }
    diagnosePolygon(portal, who, problems);
  }
  // A building may be shut off from the exterior; a room that nothing leads to is a mistake.
  for (CellId id = 1; id < graph.cells.size(); ++id) {
    if (!reached[id]) {
      problems.push_back(fmt::format("cell {} '{}' has no portal", id, graph.cells[id].name));
    }
  }
  return problems;
}

}  // namespace enfilade
