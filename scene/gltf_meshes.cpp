#include "scene/gltf_meshes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/gltf_accessors.h"
#include "scene/triangle_lists.h"

namespace enfilade {
namespace {

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

/// The name that the writer gives a mesh which shares a node with others.
std::string ownName(const tinygltf::Primitive& primitive, const std::string& otherwise) {
  if (!primitive.extras.IsObject() || !primitive.extras.Has("enfilade")) return otherwise;
  const tinygltf::Value& ours = primitive.extras.Get("enfilade");
  if (!ours.IsObject() || !ours.Has("name") || !ours.Get("name").IsString()) return otherwise;
  return ours.Get("name").Get<std::string>();
}

std::uint16_t toU16(float value) {
  // A NaN fails both comparisons and becomes 0.
  return value > 0.0f ? static_cast<std::uint16_t>(std::lround(std::min(value, 1.0f) * 65535.0f))
                      : std::uint16_t{0};
}

std::vector<glm::u16vec4> readColors(const GltfModel& gltf, int accessor) {
  std::vector<glm::u16vec4> colors;
  const auto push = [&](const glm::vec4& c) {
    colors.emplace_back(toU16(c.r), toU16(c.g), toU16(c.b), toU16(c.a));
  };
  if (accessorComponents(gltf, accessor) == 3) {
    for (const glm::vec3& c : readVec3s(gltf, accessor)) push(glm::vec4(c, 1.0f));
  } else {
    for (const glm::vec4& c : readVec4s(gltf, accessor)) push(c);
  }
  return colors;
}

std::vector<glm::vec2> readTexcoords(const GltfModel& gltf, int accessor,
                                     const std::array<float, 6>& m) {
  std::vector<glm::vec2> texcoords = readVec2s(gltf, accessor);
  const bool identity = m == TextureMapping{}.transform;
  for (glm::vec2& t : texcoords) {
    if (!identity) {
      t = {m[0] * t.x + m[1] * t.y + m[2], m[3] * t.x + m[4] * t.y + m[5]};
    }
    if (!std::isfinite(t.x) || !std::isfinite(t.y)) t = glm::vec2(0);
  }
  return texcoords;
}

Box boundsOf(const VertexArrays& vertices, const std::vector<std::uint32_t>& triangles) {
  Box bounds;
  for (const std::uint32_t i : triangles) bounds.extend(vertices.positions[i]);
  return bounds;
}

}  // namespace

MeshReader::MeshReader(const GltfModel& gltf, const std::vector<TextureMapping>& mappings,
                       Building& building, WarningLog& warnings)
    : gltf_(gltf), mappings_(mappings), building_(building), warnings_(warnings) {}

const std::vector<std::uint32_t>& MeshReader::meshesOf(int gltf_mesh) {
  if (gltf_mesh < 0 || static_cast<std::size_t>(gltf_mesh) >= gltf_->meshes.size()) {
    gltf_.fail(fmt::format("is no valid glTF: there is no mesh {}", gltf_mesh));
  }
  const auto [entry, is_new] = by_gltf_mesh_.try_emplace(gltf_mesh);
  if (!is_new) return entry->second;
  const auto& primitives = gltf_->meshes[static_cast<std::size_t>(gltf_mesh)].primitives;
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    const std::uint32_t mesh = readPrimitive(gltf_mesh, p);
    if (mesh != kNone) entry->second.push_back(mesh);
  }
  return entry->second;
}

std::uint32_t MeshReader::materialOf(int gltf_material) {
  if (gltf_material >= 0 && static_cast<std::size_t>(gltf_material) < mappings_.size()) {
    return static_cast<std::uint32_t>(gltf_material);
  }
  if (gltf_material >= 0) {
    gltf_.fail(fmt::format("is no valid glTF: there is no material {}", gltf_material));
  }
  if (default_material_ == kNone) {
    default_material_ = static_cast<std::uint32_t>(building_.materials.size());
    building_.materials.emplace_back();
  }
  return default_material_;
}

std::uint32_t MeshReader::readPrimitive(int gltf_mesh, std::size_t index) {
  const tinygltf::Mesh& mesh = gltf_->meshes[static_cast<std::size_t>(gltf_mesh)];
  const tinygltf::Primitive& primitive = mesh.primitives[index];
  const std::string subject = fmt::format("mesh {} '{}'", gltf_mesh, oneLine(mesh.name));
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    warnings_.add("points or lines left out", subject);
    return kNone;
  }
  MeshKey key;
  key.vertices.position = attribute(primitive, "POSITION");
  if (key.vertices.position < 0) {
    warnings_.add("no positions, left out", subject);
    return kNone;
  }
  if (!primitive.targets.empty()) warnings_.add("morph targets ignored", subject);
  const TextureMapping mapping =
      primitive.material >= 0 && static_cast<std::size_t>(primitive.material) < mappings_.size()
          ? mappings_[static_cast<std::size_t>(primitive.material)]
          : TextureMapping{};
  key.vertices.normal = attribute(primitive, "NORMAL");
  key.vertices.texcoord = attribute(primitive, "TEXCOORD_" + std::to_string(mapping.texcoord_set));
  key.vertices.color = attribute(primitive, "COLOR_0");
  if (key.vertices.texcoord >= 0) key.vertices.transform = mapping.transform;
  key.indices = primitive.indices;
  key.mode = primitive.mode;
  key.material = materialOf(primitive.material);
  key.name = ownName(primitive, mesh.name);

  const auto [entry, is_new] = by_key_.try_emplace(key, kNone);
  if (is_new) entry->second = readMesh(key, subject);
  return entry->second;
}

std::uint32_t MeshReader::readMesh(const MeshKey& key, const std::string& subject) {
  Mesh mesh;
  mesh.name = key.name;
  mesh.material = key.material;
  mesh.vertices = vertexArraysOf(key.vertices, subject);
  mesh.indices =
      readTriangles(key, building_.vertex_arrays[mesh.vertices].positions.size(), subject);
  if (dropNonFinite(building_.vertex_arrays[mesh.vertices], mesh.indices) > 0) {
    warnings_.add("triangles with a corner that is no number within 1e12 m, left out", subject);
  }
  if (mesh.indices.empty()) {
    warnings_.add("no triangles, left out", subject);
    return kNone;
  }
  if (key.vertices.normal < 0) {
    building_.vertex_arrays.push_back(
        unshareFlat(building_.vertex_arrays[mesh.vertices], mesh.indices));
    mesh.vertices = static_cast<std::uint32_t>(building_.vertex_arrays.size() - 1);
  }
  mesh.bounds = boundsOf(building_.vertex_arrays[mesh.vertices], mesh.indices);
  building_.meshes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(building_.meshes.size() - 1);
}

std::uint32_t MeshReader::vertexArraysOf(const VertexKey& key, const std::string& subject) {
  const auto [entry, is_new] = vertices_by_key_.try_emplace(key, kNone);
  if (!is_new) return entry->second;
  VertexArrays vertices;
  vertices.positions = readVec3s(gltf_, key.position);
  if (key.normal >= 0) vertices.normals = readVec3s(gltf_, key.normal);
  if (key.texcoord >= 0) vertices.texcoords = readTexcoords(gltf_, key.texcoord, key.transform);
  if (key.color >= 0) vertices.colors = readColors(gltf_, key.color);
  const std::size_t count = vertices.positions.size();
  for (const std::size_t size :
       {vertices.normals.size(), vertices.texcoords.size(), vertices.colors.size()}) {
    if (size != 0 && size != count) {
      gltf_.fail(
          fmt::format("{} has {} positions but {} of another attribute", subject, count, size));
    }
  }
  building_.vertex_arrays.push_back(std::move(vertices));
  entry->second = static_cast<std::uint32_t>(building_.vertex_arrays.size() - 1);
  return entry->second;
}

std::vector<std::uint32_t> MeshReader::readTriangles(const MeshKey& key, std::size_t vertex_count,
                                                     const std::string& subject) {
  std::vector<std::uint32_t> corners;
  if (key.indices >= 0) {
    corners = readIndices(gltf_, key.indices);
    for (const std::uint32_t i : corners) {
      if (i >= vertex_count) {
        gltf_.fail(fmt::format("{} has the index {} out of range: it has {} vertices", subject, i,
                               vertex_count));
      }
    }
  } else {
    gltf_.countElements(vertex_count);
    corners.resize(vertex_count);
    std::iota(corners.begin(), corners.end(), 0u);
  }
  if (key.mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0) {
    warnings_.add("corners left over at the end, ignored", subject);
  }
  const Topology topology = key.mode == TINYGLTF_MODE_TRIANGLE_STRIP ? Topology::kStrip
                            : key.mode == TINYGLTF_MODE_TRIANGLE_FAN ? Topology::kFan
                                                                     : Topology::kTriangles;
  return toTriangles(std::move(corners), topology);
}

}  // namespace enfilade
