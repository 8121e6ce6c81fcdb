#include "preprocess/marker_outline.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <map>
#include <tuple>

namespace enfilade {

namespace {

using SurfaceMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

// Vertices within a tenth of a millimetre of each other are one.
SurfaceMesh weldedMesh(const Building& building, const Object& object) {
  const Mesh& mesh = building.meshOf(object);
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  SurfaceMesh welded;
  std::map<std::tuple<long, long, long>, SurfaceMesh::VertexHandle> vertex_at;
  std::vector<SurfaceMesh::VertexHandle> corners;
  for (const std::uint32_t index : mesh.indices) {
    const glm::vec3 p(building.worldFromObject(object) * glm::vec4(positions[index], 1.0f));
    const std::tuple key(std::lround(p.x * 1e4f), std::lround(p.y * 1e4f), std::lround(p.z * 1e4f));
    auto at = vertex_at.find(key);
    if (at == vertex_at.end()) {
      at = vertex_at.emplace(key, welded.add_vertex({p.x, p.y, p.z})).first;
    }
    corners.push_back(at->second);
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (corners[i] == corners[i + 1] || corners[i + 1] == corners[i + 2] ||
        corners[i] == corners[i + 2]) {
      continue;
    }
    if (!welded.add_face(corners[i], corners[i + 1], corners[i + 2]).is_valid()) return {};
  }
  return welded;
}

std::vector<glm::vec3> withoutStraightCorners(const std::vector<glm::vec3>& loop) {
  std::vector<glm::vec3> kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::vec3 before = loop[i] - loop[(i + loop.size() - 1) % loop.size()];
    const glm::vec3 after = loop[(i + 1) % loop.size()] - loop[i];
    const float turn = glm::length(glm::cross(glm::normalize(before), glm::normalize(after)));
    if (turn > 1e-3f) kept.push_back(loop[i]);
  }
  return kept;
}

}  // namespace

std::vector<glm::vec3> outlineOf(const Building& building, const Object& object) {
  const SurfaceMesh mesh = weldedMesh(building, object);
  std::size_t border_edges = 0;
  SurfaceMesh::HalfedgeHandle start;
  for (const auto halfedge : mesh.halfedges()) {
    if (!mesh.is_boundary(halfedge)) continue;
    ++border_edges;
    start = halfedge;
  }
  if (border_edges < 3) return {};
  // Halfedges of the border run against the faces: walked backwards they give the faces' winding.
  std::vector<glm::vec3> loop;
  SurfaceMesh::HalfedgeHandle halfedge = start;
  do {
    const auto p = mesh.point(mesh.to_vertex_handle(halfedge));
    loop.emplace_back(p[0], p[1], p[2]);
    halfedge = mesh.prev_halfedge_handle(halfedge);
  } while (halfedge != start && loop.size() <= border_edges);
  if (loop.size() != border_edges) return {};  // a hole, or several pieces
  return withoutStraightCorners(loop);
}

}  // namespace enfilade
