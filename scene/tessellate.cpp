#include "scene/tessellate.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>
#include <vector>

namespace enfilade {
namespace {

constexpr std::size_t kUsuallyAdded = 1'000'000;

using Corners = std::array<std::uint32_t, 3>;

float squaredLength(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = a - b;
  return glm::dot(d, d);
}

/// The corner that begins the longest edge, or 3 if that is no longer than √`most`.  Of edges
/// equally long the first: whichever it is, all that are too long get split in the end.
std::size_t edgeToSplit(const std::array<glm::vec3, 3>& p, float most) {
  std::size_t longest = 3;
  float length = most;
  for (std::size_t k = 0; k < 3; ++k) {
    const float squared = squaredLength(p[k], p[(k + 1) % 3]);
    if (squared > length) {
      length = squared;
      longest = k;
    }
  }
  return longest;
}

/// Triangles that one becomes, no more than `most_counted`.
std::size_t countPieces(const std::array<glm::vec3, 3>& triangle, float most,
                        std::size_t most_counted) {
  std::vector<std::array<glm::vec3, 3>> pending{triangle};
  std::size_t count = 0;
  while (!pending.empty() && count + pending.size() <= most_counted) {
    const auto p = pending.back();
    pending.pop_back();
    const std::size_t k = edgeToSplit(p, most);
    if (k == 3) {
      ++count;
      continue;
    }
    const glm::vec3 middle = 0.5f * (p[k] + p[(k + 1) % 3]);
    pending.push_back({p[k], middle, p[(k + 2) % 3]});
    pending.push_back({middle, p[(k + 1) % 3], p[(k + 2) % 3]});
  }
  return count + pending.size();
}

/// The vertex arrays of some meshes while they grow by the middles of edges.
class EdgeMiddles {
 public:
  explicit EdgeMiddles(VertexArrays& vertices) : vertices_(vertices) {}

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t key = std::uint64_t{low} << 32 | high;
    const auto [entry, is_new] =
        middles_.try_emplace(key, static_cast<std::uint32_t>(vertices_.positions.size()));
    if (is_new) add(low, high);
    return entry->second;
  }

 private:
  void add(std::uint32_t a, std::uint32_t b) {
    vertices_.positions.push_back(0.5f * (vertices_.positions[a] + vertices_.positions[b]));
    if (!vertices_.normals.empty()) {
      const glm::vec3 sum = vertices_.normals[a] + vertices_.normals[b];
      const float length = glm::length(sum);
      vertices_.normals.push_back(length > 1e-6f ? sum / length : vertices_.normals[a]);
    }
    if (!vertices_.texcoords.empty()) {
      vertices_.texcoords.push_back(0.5f * (vertices_.texcoords[a] + vertices_.texcoords[b]));
    }
    if (!vertices_.colors.empty()) {
      const glm::uvec4 sum = glm::uvec4(vertices_.colors[a]) + glm::uvec4(vertices_.colors[b]);
      vertices_.colors.push_back(glm::u16vec4((sum + 1u) / 2u));
    }
  }

  VertexArrays& vertices_;
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

std::array<glm::vec3, 3> placed(const VertexArrays& vertices, const glm::mat4& m,
                                const Corners& c) {
  std::array<glm::vec3, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = glm::vec3(m * glm::vec4(vertices.positions[c[k]], 1.0f));
  }
  return p;
}

void splitMesh(Mesh& mesh, VertexArrays& vertices, EdgeMiddles& middles, const glm::mat4& m,
               float most) {
  std::vector<std::uint32_t> split;
  std::vector<Corners> pending;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    pending.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    while (!pending.empty()) {
      const Corners c = pending.back();
      pending.pop_back();
      const std::size_t k = edgeToSplit(placed(vertices, m, c), most);
      if (k == 3) {
        split.insert(split.end(), c.begin(), c.end());
        continue;
      }
      const std::uint32_t next = c[(k + 1) % 3], opposite = c[(k + 2) % 3];
      const std::uint32_t middle = middles.between(c[k], next);
      pending.push_back({middle, next, opposite});
      pending.push_back({c[k], middle, opposite});
    }
  }
  mesh.indices = std::move(split);
}

std::size_t countAdded(const Building& building, std::span<const MeshToSplit> meshes, float most,
                       std::size_t most_counted) {
  std::size_t added = 0;
  for (const MeshToSplit& wanted : meshes) {
    const Mesh& mesh = building.meshes[wanted.mesh];
    const VertexArrays& vertices = building.vertex_arrays[mesh.vertices];
    for (std::size_t i = 0; i + 2 < mesh.indices.size() && added <= most_counted; i += 3) {
      const Corners c{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
      added +=
          countPieces(placed(vertices, wanted.world_from_mesh, c), most, most_counted - added + 2) -
          1;
    }
  }
  return added;
}

}  // namespace

float splitLongEdges(Building& building, std::span<const MeshToSplit> meshes, float longest,
                     std::size_t most_added) {
  assert(longest > 0);
  while (countAdded(building, meshes, longest * longest, most_added) > most_added) longest *= 2;
  std::unordered_map<std::uint32_t, EdgeMiddles> middles;
  for (const MeshToSplit& wanted : meshes) {
    Mesh& mesh = building.meshes[wanted.mesh];
    VertexArrays& vertices = building.vertex_arrays[mesh.vertices];
    EdgeMiddles& known = middles.try_emplace(mesh.vertices, vertices).first->second;
    splitMesh(mesh, vertices, known, wanted.world_from_mesh, longest * longest);
  }
  return longest;
}

float splitLongEdges(Building& building, float longest) {
  std::vector<MeshToSplit> meshes;
  std::vector<std::size_t> place(building.meshes.size(), building.meshes.size());
  for (const Object& object : building.objects) {
    const glm::mat4& m = building.worldFromObject(object);
    if (place[object.mesh] == building.meshes.size()) {
      place[object.mesh] = meshes.size();
      meshes.push_back({object.mesh, m});
      continue;
    }
    glm::mat4& known = meshes[place[object.mesh]].world_from_mesh;
    const float size = std::abs(glm::determinant(glm::mat3(m)));
    if (size > 1.001f * std::abs(glm::determinant(glm::mat3(known)))) known = m;
  }
  return splitLongEdges(building, meshes, longest,
                        std::max(kUsuallyAdded, triangleCount(building)));
}

}  // namespace enfilade
