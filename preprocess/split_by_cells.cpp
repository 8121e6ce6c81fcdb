#include <algorithm>
#include <map>

#include "preprocess/share_geometry.h"

namespace enfilade {

namespace {

using CellSet = std::vector<CellId>;

std::vector<CellSet> setOfEachPatch(const Patches& patches, const PatchCells& claims) {
  std::vector<CellSet> sets(patches.count);
  for (const PatchCells::Claim& claim : claims.claims) sets[claim.patch].push_back(claim.cell);
  return sets;
}

// An object's triangles by their set of cells, in order of each set's first triangle.
struct Part {
  CellSet cells;
  std::vector<std::uint32_t> triangles;
};

std::vector<Part> partsOf(const std::vector<std::uint32_t>& patch_of_triangle,
                          const std::vector<CellSet>& sets) {
  std::vector<Part> parts;
  std::map<CellSet, std::size_t> part_of_set;
  for (std::uint32_t t = 0; t < patch_of_triangle.size(); ++t) {
    const CellSet& cells = sets[patch_of_triangle[t]];
    const auto [at, added] = part_of_set.try_emplace(cells, parts.size());
    if (added) parts.push_back({cells, {}});
    parts[at->second].triangles.push_back(t);
  }
  return parts;
}

Mesh subMesh(const Building& building, const Mesh& mesh,
             const std::vector<std::uint32_t>& triangles) {
  Mesh part;
  part.name = mesh.name;
  part.vertices = mesh.vertices;
  part.material = mesh.material;
  part.indices.reserve(3 * triangles.size());
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  for (const std::uint32_t t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t index = mesh.indices[3 * t + k];
      part.indices.push_back(index);
      part.bounds.extend(positions[index]);
    }
  }
  return part;
}

}  // namespace

SharedGeometry splitByCells(const Building& building, std::span<const ObjectRole> roles,
                            const Patches& patches, const PatchCells& claims) {
  SharedGeometry out;
  out.building = building;
  out.building.nodes.clear();
  out.building.objects.clear();
  out.building.meshes.clear();
  const std::vector<CellSet> sets = setOfEachPatch(patches, claims);
  std::map<std::uint32_t, std::uint32_t>
      whole_meshes;  // the model's meshes that stay as they are, still shared
  for (std::size_t o = 0; o < building.objects.size(); ++o) {
    const Object& object = building.objects[o];
    const std::vector<Part> parts = partsOf(patches.patch_of_triangle[o], sets);
    for (const Part& part : parts) {
      std::uint32_t mesh = static_cast<std::uint32_t>(out.building.meshes.size());
      if (parts.size() == 1) mesh = whole_meshes.try_emplace(object.mesh, mesh).first->second;
      if (mesh == out.building.meshes.size()) {
        out.building.meshes.push_back(
            parts.size() == 1 ? building.meshOf(object)
                              : subMesh(building, building.meshOf(object), part.triangles));
      }
      // A node for each object, so that any viewer can show them one by one.
      Node node = building.nodes[object.node];
      node.parent = kNone;
      node.extras.clear();
      const auto index = static_cast<std::uint32_t>(out.building.nodes.size());
      out.building.nodes.push_back(std::move(node));
      out.building.objects.push_back({index, mesh});
      out.roles.push_back(roles[o]);
      out.cells.push_back(part.cells);
    }
  }
  return out;
}

}  // namespace enfilade
