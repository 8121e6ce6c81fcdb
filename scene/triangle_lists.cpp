#include "scene/triangle_lists.h"

#include <cmath>

#include "scene/building_repair.h"

namespace enfilade {
namespace {

bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename T>
std::vector<T> gather(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> gathered;
  if (values.empty()) return gathered;
  gathered.reserve(indices.size());
  for (const std::uint32_t i : indices) gathered.push_back(values[i]);
  return gathered;
}

}  // namespace

std::vector<std::uint32_t> toTriangles(std::vector<std::uint32_t> corners, Topology topology) {
  if (topology == Topology::kTriangles) {
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (topology == Topology::kStrip) {
      triangles.insert(triangles.end(),
                       {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    } else {
      triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    }
  }
  return triangles;
}

VertexArrays unshareFlat(const VertexArrays& vertices, std::vector<std::uint32_t>& triangles) {
  VertexArrays flat;
  flat.positions = gather(vertices.positions, triangles);
  flat.texcoords = gather(vertices.texcoords, triangles);
  flat.colors = gather(vertices.colors, triangles);
  flat.normals.reserve(triangles.size());
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    flat.normals.insert(
        flat.normals.end(), 3,
        faceNormal(flat.positions[i], flat.positions[i + 1], flat.positions[i + 2]));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = static_cast<std::uint32_t>(i);
  return flat;
}

std::size_t dropNonFinite(const VertexArrays& vertices, std::vector<std::uint32_t>& triangles) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const bool finite = isFinite(vertices.positions[triangles[i]]) &&
                        isFinite(vertices.positions[triangles[i + 1]]) &&
                        isFinite(vertices.positions[triangles[i + 2]]);
    if (!finite) continue;
    for (std::size_t c = 0; c < 3; ++c) triangles[kept + c] = triangles[i + c];
    kept += 3;
  }
  const std::size_t dropped = (triangles.size() - kept) / 3;
  triangles.resize(kept);
  return dropped;
}

}  // namespace enfilade
