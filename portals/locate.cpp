#include <algorithm>
#include <cmath>
#include <limits>

#include "portals/cell_grid.h"
#include "portals/polygon.h"

namespace enfilade {

namespace {

/// A voxel that a portal crosses lies this near to it [voxels]: its diagonal, and room for portals
/// that were rasterised a voxel thicker.
constexpr float kCutReach = 3.5f;

/// The labelled voxels beside a portal's are this near [voxels].
constexpr int kLabelReach = 2;

/// Around a portal, this far [voxels] beside its polygon, stands its own frame: a way through there
/// is a way through the portal.
constexpr float kFrameReach = 3.0f;

/// The nearest portal within `reach`; null with none.
const Portal* nearestPortal(const CellGraph& graph, const glm::vec3& p, float reach) {
  const Portal* nearest = nullptr;
  for (const Portal& portal : graph.portals) {
    if (std::abs(portal.plane.signedDistance(p)) > reach) continue;
    const float distance = distanceToPolygon(portal.polygon, portal.plane, p);
    if (distance > reach || (distance == reach && nearest != nullptr)) continue;
    reach = distance;
    nearest = &portal;
  }
  return nearest;
}

/// Whether no portal, grown by `grow` [m], stands between two points.
bool isClear(const CellGraph& graph, const glm::vec3& a, const glm::vec3& b, float grow) {
  return std::none_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
    return segmentCrosses(portal.polygon, portal.plane, a, b, grow);
  });
}

/// The cell of a point in a voxel that `portal` crosses: on its side of the plane, that of the
/// portal's two cells whose labelled voxel is nearest.  It need not be the one that the portal has
/// on this side: above a stair that the portal runs along one cell may reach around it.
CellId cellBeside(const CellGraph& graph, const CellGrid& grid, const Portal& portal,
                  const glm::vec3& p) {
  const bool in_front = portal.plane.signedDistance(p) >= 0;
  CellId cell = in_front ? portal.front : portal.back;
  const glm::ivec3 start = grid.voxelOf(p);
  float nearest = std::numeric_limits<float>::infinity();
  for (int x = -kLabelReach; x <= kLabelReach; ++x) {
    for (int z = -kLabelReach; z <= kLabelReach; ++z) {
      for (int y = -kLabelReach; y <= kLabelReach; ++y) {
        const glm::ivec3 v = start + glm::ivec3(x, y, z);
        const CellGrid::Label label = grid.labelAt(v);
        if (label != portal.front && label != portal.back) continue;
        const glm::vec3 center = grid.centerOf(v);
        const float distance = glm::distance(p, center);
        if (distance >= nearest || (portal.plane.signedDistance(center) >= 0) != in_front) continue;
        if (!isClear(graph, p, center, 0)) continue;
        nearest = distance;
        cell = label;
      }
    }
  }
  return cell;
}

/// Looks for the labelled voxel nearest to a point in something solid, column by column in rings
/// about it; one that is reached without passing a portal is preferred.
class NearestLabel {
 public:
  NearestLabel(const CellGraph& graph, const CellGrid& grid, const glm::vec3& p)
      : graph_(graph), grid_(grid), p_(p), start_(grid.voxelOf(p)) {}

  CellId find() {
    offerBeyondTheGrid();
    const int last = std::max(grid_.size().x, grid_.size().z);
    for (int ring = 0; ring < last && static_cast<float>(ring - 1) * grid_.voxel() < limit();
         ++ring) {
      scanRing(ring);
    }
    return clear_.cell != kNoCell ? clear_.cell : any_.cell;
  }

 private:
  struct Best {
    CellId cell = kNoCell;
    float distance = std::numeric_limits<float>::infinity();
  };

  /// Nothing farther need be looked at: with no clear way by twice the distance there is none.
  float limit() const {
    return clear_.cell != kNoCell ? clear_.distance : 2 * any_.distance + 4 * grid_.voxel();
  }

  void offer(CellId cell, const glm::vec3& center) {
    const float distance = glm::distance(p_, center);
    if (distance < any_.distance) any_ = {cell, distance};
    if (distance < clear_.distance && isClear(graph_, p_, center, kFrameReach * grid_.voxel())) {
      clear_ = {cell, distance};
    }
  }

  void offerBeyondTheGrid() {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int outside : {-1, grid_.size()[axis]}) {
        glm::vec3 target = p_;
        target[axis] = grid_.origin()[axis] + (static_cast<float>(outside) + 0.5f) * grid_.voxel();
        offer(kExterior, target);
      }
    }
  }

  void scanRing(int ring) {
    for (int dx = -ring; dx <= ring; ++dx) {
      const int step = std::abs(dx) == ring || ring == 0 ? 1 : 2 * ring;
      for (int dz = -ring; dz <= ring; dz += step) scanColumn(start_.x + dx, start_.z + dz);
    }
  }

  void scanColumn(int x, int z) {
    if (x < 0 || z < 0 || x >= grid_.size().x || z >= grid_.size().z) return;
    int begin = 0;
    for (const CellGrid::Run& run : grid_.column(x, z)) {
      if (run.label < graph_.cells.size()) {
        const int y = std::clamp(start_.y, begin, run.end_y - 1);
        offer(run.label, grid_.centerOf({x, y, z}));
      }
      begin = run.end_y;
    }
  }

  const CellGraph& graph_;
  const CellGrid& grid_;
  const glm::vec3 p_;
  const glm::ivec3 start_;
  Best any_;
  Best clear_;
};

}  // namespace

CellLocation locate(const CellGraph& graph, const CellGrid& grid, const glm::vec3& p) {
  const CellGrid::Label label = grid.labelAt(grid.voxelOf(p));
  if (label < graph.cells.size()) return {label, true};
  if (label == CellGrid::kCutVoxel) {
    const Portal* portal = nearestPortal(graph, p, kCutReach * grid.voxel());
    if (portal != nullptr) return {cellBeside(graph, grid, *portal, p), true};
  }
  return {NearestLabel(graph, grid, p).find(), false};
}

}  // namespace enfilade
