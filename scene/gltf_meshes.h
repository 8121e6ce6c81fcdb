#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scene/building.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_model.h"

namespace enfilade {

/// Reads glTF meshes into Building::meshes and Building::vertex_arrays, each once.
/// Primitives that name the same accessors share their vertex arrays.  Primitives without normals
/// get flat ones and vertices of their own (the arrays that they came from stay behind, unused).
/// Strips and fans become triangles; points and lines, and triangles with a corner that is not
/// finite, are left out with a warning.
class MeshReader {
 public:
  /// All must outlive this.  `mappings` has one element a material of the glTF.
  MeshReader(const GltfModel& gltf, const std::vector<TextureMapping>& mappings, Building& building,
             WarningLog& warnings);

  /// Indices in Building::meshes of the glTF mesh's primitives, those that have triangles.  Throws
  /// Error (kBadInput).
  const std::vector<std::uint32_t>& meshesOf(int gltf_mesh);

 private:
  /// What makes two primitives' vertices the same.
  struct VertexKey {
    int position = -1;
    int normal = -1;
    int texcoord = -1;
    int color = -1;
    std::array<float, 6> transform{};
    auto operator<=>(const VertexKey&) const = default;
  };
  /// What makes two primitives the same.
  struct MeshKey {
    VertexKey vertices;
    int indices = -1;
    int mode = -1;
    std::uint32_t material = 0;
    std::string name;
    auto operator<=>(const MeshKey&) const = default;
  };

  /// kNone if there is nothing to draw in it.
  std::uint32_t readPrimitive(int gltf_mesh, std::size_t primitive);
  std::uint32_t readMesh(const MeshKey& key, const std::string& subject);
  std::uint32_t vertexArraysOf(const VertexKey& key, const std::string& subject);
  std::vector<std::uint32_t> readTriangles(const MeshKey& key, std::size_t vertex_count,
                                           const std::string& subject);
  std::uint32_t materialOf(int gltf_material);

  const GltfModel& gltf_;
  const std::vector<TextureMapping>& mappings_;
  Building& building_;
  WarningLog& warnings_;
  std::uint32_t default_material_ = kNone;
  std::map<int, std::vector<std::uint32_t>> by_gltf_mesh_;
  std::map<MeshKey, std::uint32_t> by_key_;
  std::map<VertexKey, std::uint32_t> vertices_by_key_;
};

}  // namespace enfilade
