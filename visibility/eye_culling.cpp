#include "visibility/eye_culling.h"

#include <algorithm>
#include <cmath>

#include "portals/polygon.h"
#include "visibility/screen_matrix.h"

namespace enfilade {

namespace {

/// A voxel that a portal crosses lies this near to its plane [voxels].
constexpr float kCutReach = 2.0f;

/// More voxels than this about the near plane are not looked through: it counts as cutting.
constexpr float kMostVoxelsAcross = 64;

/// Holds the eye and the near plane's corners.
Box nearBox(const View& view) {
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
  Box box{view.eye, view.eye};
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec4 corner = world_from_clip * glm::dvec4(x, y, -1, 1);
      box.extend(glm::vec3(glm::dvec3(corner) / corner.w));
    }
  }
  return box;
}

/// The sides of the pyramid from the eye to the near plane, which is its base.
std::vector<Plane> nearPyramid(const View& view) {
  std::vector<Plane> planes = wholeScreen(view).planes;
  const glm::dmat4 rows = glm::transpose(glm::dmat4(view.clip_from_world));
  planes.push_back(unitPlane(-(rows[3] + rows[2])));
  return planes;
}

/// Every cell over the whole screen, seen through no portal.
VisibleSet everyCell(const CellGraph& graph, const View& view, CellId eye_cell) {
  const ScreenRegion screen = wholeScreen(view);
  VisibleSet set;
  set.eye_cell = eye_cell;
  for (CellId cell = 0; cell < graph.cells.size(); ++cell) set.cells.push_back({cell, {screen}});
  return set;
}

}  // namespace

bool eyeIsInFreeSpace(const CellGraph& graph, const CellGrid& grid, const glm::vec3& eye) {
  const CellGrid::Label label = grid.labelAt(grid.voxelOf(eye));
  if (label == CellGrid::kSolidVoxel) return false;
  if (label != CellGrid::kCutVoxel) return true;
  const float reach = kCutReach * grid.voxel();
  return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
    return std::abs(portal.plane.signedDistance(eye)) <= reach &&
           distanceInPlane(portal.polygon, portal.plane, eye) <= kPortalMargin;
  });
}

bool isUnderEveryFloor(const CellGraph& graph, const glm::vec3& eye) {
  return std::all_of(graph.storeys.begin(), graph.storeys.end(),
                     [&](const Storey& storey) { return eye.y < storey.floor_y; });
}

bool nearPlaneIsInFreeSpace(const CellGrid& grid, const View& view) {
  const Box box = nearBox(view);
  if (!glm::all(glm::lessThan(box.size(), glm::vec3(kMostVoxelsAcross * grid.voxel())))) {
    return false;
  }
  const std::vector<Plane> pyramid = nearPyramid(view);
  const glm::ivec3 least = grid.voxelOf(box.min);
  const glm::ivec3 most = grid.voxelOf(box.max);
  const glm::vec3 half(0.5f * grid.voxel());
  for (int x = least.x; x <= most.x; ++x) {
    for (int z = least.z; z <= most.z; ++z) {
      for (int y = least.y; y <= most.y; ++y) {
        if (grid.labelAt({x, y, z}) != CellGrid::kSolidVoxel) continue;
        const glm::vec3 center = grid.centerOf({x, y, z});
        if (mayTouch(pyramid, Box{center - half, center + half})) return false;
      }
    }
  }
  return true;
}

VisibleSet cullFromEye(const CellGraph& graph, const CellGrid& grid, const View& view,
                       const ShowAsImage& show_as_image) {
  const CellId cell = locate(graph, grid, view.eye).cell;
  const bool is_within = eyeIsInFreeSpace(graph, grid, view.eye) &&
                         nearPlaneIsInFreeSpace(grid, view) &&
                         !(cell == kExterior && isUnderEveryFloor(graph, view.eye));
  return is_within ? cullByPortals(graph, view, cell, show_as_image) : everyCell(graph, view, cell);
}

}  // namespace enfilade
