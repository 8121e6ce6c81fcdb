#include "scene/building_repair.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/error.h"

namespace enfilade {
namespace {

/// In double precision, so that tiny triangles have a direction too.
glm::dvec3 areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

bool hasDirection(const glm::dvec3& v) {
  const double length = glm::length(v);
  return std::isfinite(length) && length > 0.0;
}

glm::vec3 directionOf(const glm::dvec3& v) {
  return hasDirection(v) ? glm::vec3(glm::normalize(v)) : glm::vec3(0, 1, 0);
}

/// For each vertex array empty, or one sum a vertex if it has normals without a direction.
std::vector<std::vector<glm::dvec3>> sumsWhereNeeded(const Building& building) {
  std::vector<std::vector<glm::dvec3>> sums(building.vertex_arrays.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    for (const glm::vec3& normal : building.vertex_arrays[v].normals) {
      if (hasDirection(normal)) continue;
      sums[v].assign(building.vertex_arrays[v].positions.size(), glm::dvec3(0));
      break;
    }
  }
  for (const Mesh& mesh : building.meshes) {
    const std::vector<glm::vec3>& p = building.vertex_arrays[mesh.vertices].positions;
    std::vector<glm::dvec3>& sum = sums[mesh.vertices];
    for (std::size_t i = 0; !sum.empty() && i + 2 < mesh.indices.size(); i += 3) {
      const auto* corner = &mesh.indices[i];
      const glm::dvec3 normal = areaNormal(p[corner[0]], p[corner[1]], p[corner[2]]);
      for (int c = 0; c < 3; ++c) sum[corner[c]] += normal;
    }
  }
  return sums;
}

bool isWithinReach(const glm::mat4& world_from_object, const Box& box) {
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 corner((i & 1) != 0 ? box.min.x : box.max.x,
                           (i & 2) != 0 ? box.min.y : box.max.y,
                           (i & 4) != 0 ? box.min.z : box.max.z);
    const glm::vec3 p(world_from_object * glm::vec4(corner, 1));
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(p[axis]) <= kFarthest)) return false;
    }
  }
  return true;
}

}  // namespace

void requireWithinReach(const Building& building, const std::string& file) {
  const auto fail = [&](const Node& node) {
    throw Error(ErrorKind::kBadInput, file,
                fmt::format("places node '{}' beyond {} m", oneLine(node.name), kFarthest));
  };
  for (const Node& node : building.nodes) {
    if (!isWithinReach(node.world_from_node, {glm::vec3(-1), glm::vec3(1)})) fail(node);
  }
  for (const Object& object : building.objects) {
    if (!isWithinReach(building.worldFromObject(object), building.meshOf(object).bounds)) {
      fail(building.nodes[object.node]);
    }
  }
}

glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return directionOf(areaNormal(a, b, c));
}

std::size_t countWithoutArea(const Building& building) {
  std::size_t count = 0;
  for (const Mesh& mesh : building.meshes) {
    const std::vector<glm::vec3>& p = building.vertex_arrays[mesh.vertices].positions;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const auto* corner = &mesh.indices[i];
      if (!hasDirection(areaNormal(p[corner[0]], p[corner[1]], p[corner[2]]))) ++count;
    }
  }
  return count;
}

void dropUnusedVertexArrays(Building& building) {
  std::vector<std::uint32_t> new_index(building.vertex_arrays.size(), kNone);
  for (const Mesh& mesh : building.meshes) new_index[mesh.vertices] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] == kNone) continue;
    if (kept != i) building.vertex_arrays[kept] = std::move(building.vertex_arrays[i]);
    new_index[i] = kept++;
  }
  building.vertex_arrays.resize(kept);
  for (Mesh& mesh : building.meshes) mesh.vertices = new_index[mesh.vertices];
}

void mendPositions(Building& building) {
  for (VertexArrays& vertices : building.vertex_arrays) {
    for (glm::vec3& p : vertices.positions) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) p = glm::vec3(0);
    }
  }
}

std::size_t mendNormals(Building& building) {
  const std::vector<std::vector<glm::dvec3>> sums = sumsWhereNeeded(building);
  std::size_t without = 0;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    std::vector<glm::vec3>& normals = building.vertex_arrays[v].normals;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (std::abs(glm::dot(normals[i], normals[i]) - 1.0f) < 1e-4f) continue;
      const bool mended = !hasDirection(normals[i]);
      if (mended) ++without;
      normals[i] = directionOf(mended ? sums[v][i] : glm::dvec3(normals[i]));
    }
  }
  return without;
}

void mendNormals(Building& building, WarningLog& warnings) {
  if (const std::size_t mended = mendNormals(building); mended > 0) {
    warnings.add("normals without a direction, computed", fmt::format("{} vertices", mended));
  }
  if (const std::size_t count = countWithoutArea(building); count > 0) {
    warnings.add("triangles without area", std::to_string(count));
  }
}

}  // namespace enfilade
