#include "preprocess/tour_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace enfilade {

namespace {

constexpr float kLookEvery = 0.05f;  // [m]

// Calls `visit` with the index of a segment and the cell at points of free space along it.
void walkCells(const House& house, const CameraPath& path,
               const std::function<void(std::size_t, CellId)>& visit) {
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const glm::vec3 a = path.poses[i].pose.position;
    const glm::vec3 b = i + 1 < path.poses.size() ? path.poses[i + 1].pose.position : a;
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(b - a) / kLookEvery)));
    for (int k = 0; k < steps; ++k) {
      const glm::vec3 p = glm::mix(a, b, static_cast<float>(k) / static_cast<float>(steps));
      const CellLocation at = locate(house.graph, house.grid, p);
      if (at.in_free_space) visit(i, at.cell);
    }
  }
}

bool joined(const CellGraph& graph, CellId a, CellId b) {
  return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& p) {
    return p.active && ((p.front == a && p.back == b) || (p.front == b && p.back == a));
  });
}

std::string cellName(const CellGraph& graph, CellId cell) {
  return cell < graph.cells.size() ? graph.cells[cell].name : "no cell";
}

}  // namespace

std::vector<TourViolation> checkTour(const House& house, const CameraPath& path,
                                     float least_distance) {
  return checkTour(house, ObstacleBins(house), path, least_distance);
}

std::vector<TourViolation> checkTour(const House& house, const ObstacleBins& obstacles,
                                     const CameraPath& path, float least_distance) {
  std::vector<TourViolation> violations;
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const glm::vec3 p = path.poses[i].pose.position;
    const float distance = obstacles.distance(p, least_distance);
    if (distance < least_distance) {
      violations.push_back({i, fmt::format("the eye is {:.3f} m from something solid", distance)});
    }
    if (i + 1 < path.poses.size() && obstacles.crosses(p, path.poses[i + 1].pose.position)) {
      violations.push_back({i, "the way to the next pose crosses something solid"});
    }
  }
  CellId before = kNoCell;
  walkCells(house, path, [&](std::size_t i, CellId cell) {
    if (before != kNoCell && before != cell && !joined(house.graph, before, cell)) {
      violations.push_back(
          {i, fmt::format("goes from {} to {}, which no open portal joins",
                          cellName(house.graph, before), cellName(house.graph, cell))});
    }
    before = cell;
  });
  return violations;
}

std::vector<CellId> cellsAlong(const House& house, const CameraPath& path) {
  std::vector<CellId> cells;
  walkCells(house, path, [&](std::size_t, CellId cell) { cells.push_back(cell); });
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace enfilade
