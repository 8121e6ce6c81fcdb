#include "preprocess/patches.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace enfilade {

namespace {

// For each triangle of a mesh the number of its connected piece.
std::vector<std::uint32_t> connectedPieces(const Building& building, const Mesh& mesh) {
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  // Welds equal positions: corners sorted by place, equal ones joined.
  std::vector<std::uint32_t> corners(mesh.indices.size());
  std::iota(corners.begin(), corners.end(), 0u);
  const auto place = [&](std::uint32_t corner) {
    const glm::vec3& p = positions[mesh.indices[corner]];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(place(a), a) < std::tuple(place(b), b);
  });
  std::vector<std::uint32_t> parent(mesh.indices.size() / 3);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (place(corners[i]) != place(corners[i - 1])) continue;
    const std::uint32_t a = find(corners[i] / 3);
    const std::uint32_t b = find(corners[i - 1] / 3);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> piece(parent.size());
  for (std::uint32_t t = 0; t < piece.size(); ++t) piece[t] = find(t);
  return piece;
}

std::vector<Box> pieceBounds(const Building& building, const Object& object,
                             const std::vector<std::uint32_t>& piece) {
  const Mesh& mesh = building.meshOf(object);
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  const glm::mat4& world_from_object = building.worldFromObject(object);
  std::vector<Box> bounds(piece.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec4 p(positions[mesh.indices[i]], 1.0f);
    bounds[piece[i / 3]].extend(glm::vec3(world_from_object * p));
  }
  return bounds;
}

}  // namespace

Patches makePatches(const Building& building, float largest) {
  Patches out;
  std::vector<std::vector<std::uint32_t>> pieces(
      building.meshes.size());  // shared by a mesh's objects
  for (const Object& object : building.objects) {
    auto& piece = pieces[object.mesh];
    if (piece.empty()) piece = connectedPieces(building, building.meshOf(object));
    const std::vector<Box> bounds = pieceBounds(building, object, piece);
    std::vector<std::uint32_t> patch(piece.size());
    for (std::uint32_t t = 0; t < piece.size(); ++t) {
      const bool whole = glm::length(bounds[piece[t]].size()) <= largest;
      // A piece is numbered at its first triangle, which leads it.
      patch[t] = whole && piece[t] != t ? patch[piece[t]] : out.count++;
    }
    out.patch_of_triangle.push_back(std::move(patch));
  }
  return out;
}

}  // namespace enfilade
