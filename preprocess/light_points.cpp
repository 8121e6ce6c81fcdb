#include "preprocess/light_points.h"

#include <algorithm>
#include <cmath>

#include "preprocess/surface_albedo.h"

namespace enfilade {
namespace {

constexpr float kCell = 0.03f;        // vertices in one such cube share a point [m]
constexpr float kFromEdges = 0.01f;   // points are drawn this far into the faces [m]
constexpr float kLargeArea = 0.002f;  // of the faces about a point: a large one [m²]

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-12f ? v / length : otherwise;
}

/// The vertices of one object while its points are made.
class ObjectPoints {
 public:
  ObjectPoints(const Building& building, const WorldGeometry& world, std::uint32_t object,
               LightPoints& points)
      : building_(building),
        world_(world),
        object_(object),
        range_(verticesOf(world, object)),
        points_(points) {
    measureFaces();
    takeNormals();
  }

  void make(const AlbedoOf& albedo) {
    const std::vector<std::uint32_t> source = sourceVertices(building_, world_, object_);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    Box box;
    for (std::uint32_t i = 0; i < range_.count; ++i) box.extend(position(i));
    for (std::uint32_t i = 0; i < range_.count; ++i) keyed.emplace_back(keyOf(i, box.min), i);
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t from = 0, to = 0; from < keyed.size(); from = to) {
      while (to < keyed.size() && keyed[to].first == keyed[from].first) ++to;
      std::vector<std::uint32_t> members;
      for (std::size_t k = from; k < to; ++k) members.push_back(keyed[k].second);
      addPoint(members, source, albedo);
    }
  }

 private:
  const glm::vec3& position(std::uint32_t i) const {
    return world_.vertices[range_.first + i].position;
  }
  const glm::vec3& normal(std::uint32_t i) const {
    return points_.vertex_normals[range_.first + i];
  }

  /// Areas, face normals and centroids of the triangles about each vertex.
  void measureFaces() {
    areas_.assign(range_.count, 0);
    face_normals_.assign(range_.count, glm::vec3(0));
    centroids_.assign(range_.count, glm::vec3(0));
    const IndexRange& indices = world_.objects[object_];
    for (std::size_t i = indices.first; i + 2 < indices.first + indices.count; i += 3) {
      const std::uint32_t* c = &world_.indices[i];
      const glm::vec3 p = world_.vertices[c[0]].position, q = world_.vertices[c[1]].position,
                      r = world_.vertices[c[2]].position;
      const glm::vec3 normal = 0.5f * glm::cross(q - p, r - p);
      const float area = glm::length(normal);
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = c[k] - range_.first;
        areas_[v] += area / 3;
        face_normals_[v] += normal;
        centroids_[v] += area * (p + q + r) / 3.0f;
      }
    }
    for (std::uint32_t v = 0; v < range_.count; ++v) {
      if (areas_[v] > 0) centroids_[v] /= 3 * areas_[v];
    }
  }

  void takeNormals() {
    const VertexArrays& arrays = building_.vertex_arrays[building_.meshes[mesh()].vertices];
    const glm::mat3 m(building_.worldFromObject(building_.objects[object_]));
    const float sign = glm::determinant(m) < 0 ? -1.0f : 1.0f;
    const glm::mat3 world_from_normal(sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]),
                                      sign * glm::cross(m[0], m[1]));
    const std::vector<std::uint32_t> source = sourceVertices(building_, world_, object_);
    const bool one_sided = !building_.materialOf(building_.objects[object_]).double_sided;
    for (std::uint32_t i = 0; i < range_.count; ++i) {
      const glm::vec3 face = unitOr(face_normals_[i], glm::vec3(0, 1, 0));
      glm::vec3 n = face;
      if (!arrays.normals.empty()) n = unitOr(world_from_normal * arrays.normals[source[i]], face);
      if (one_sided && glm::dot(n, face) < 0) n = face;  // a normal that looks into the solid
      points_.vertex_normals[range_.first + i] = n;
    }
  }

  std::uint64_t keyOf(std::uint32_t i, const glm::vec3& origin) const {
    const glm::vec3 cell = glm::floor((position(i) - origin) / kCell);
    const glm::ivec3 way = glm::ivec3(glm::round(normal(i))) + 1;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      key = key << 19 | (static_cast<std::uint64_t>(cell[axis]) & 0x7ffff);
    }
    return key << 5 | static_cast<std::uint64_t>(way.x + 3 * way.y + 9 * way.z);
  }

  void addPoint(const std::vector<std::uint32_t>& members, const std::vector<std::uint32_t>& source,
                const AlbedoOf& albedo) {
    glm::vec3 mean(0);
    float area = 0;
    for (const std::uint32_t i : members) {
      mean += position(i) / static_cast<float>(members.size());
      area += areas_[i];
    }
    const auto apart = [&](std::uint32_t i) { return glm::distance(position(i), mean); };
    std::uint32_t nearest = members[0];
    for (const std::uint32_t i : members) {
      if (apart(i) < apart(nearest)) nearest = i;
    }
    const auto number = static_cast<std::uint32_t>(points_.size());
    for (const std::uint32_t i : members) points_.of_vertex[range_.first + i] = number;
    points_.positions.push_back(drawnIn(nearest));
    points_.normals.push_back(normal(nearest));
    points_.albedos.push_back(albedo.at(object_, source[nearest]));
    points_.areas.push_back(area);
    points_.large.push_back(area > kLargeArea ? 1 : 0);
    points_.objects.push_back(object_);
  }

  /// Away from the edges of its faces, where it would sit in the crease with the next one.
  glm::vec3 drawnIn(std::uint32_t i) const {
    if (!(areas_[i] > 0)) return position(i);
    glm::vec3 in = centroids_[i] - position(i);
    in -= glm::dot(in, normal(i)) * normal(i);
    const float length = glm::length(in);
    if (length < 1e-6f) return position(i);
    return position(i) + in * (std::min(kFromEdges, 0.3f * length) / length);
  }

  std::uint32_t mesh() const { return building_.objects[object_].mesh; }

  const Building& building_;
  const WorldGeometry& world_;
  std::uint32_t object_;
  VertexRange range_;
  LightPoints& points_;
  std::vector<float> areas_;
  std::vector<glm::vec3> face_normals_, centroids_;
};

}  // namespace

VertexRange verticesOf(const WorldGeometry& world, std::uint32_t object) {
  const IndexRange& range = world.objects[object];
  if (range.count == 0) return {};
  const auto begin = world.indices.begin() + static_cast<std::ptrdiff_t>(range.first);
  const auto [least, most] = std::minmax_element(begin, begin + range.count);
  return {*least, *most - *least + 1};
}

std::vector<std::uint32_t> sourceVertices(const Building& building, const WorldGeometry& world,
                                          std::uint32_t object) {
  const VertexRange range = verticesOf(world, object);
  std::vector<std::uint32_t> source(range.count);
  const std::vector<std::uint32_t>& indices = building.meshOf(building.objects[object]).indices;
  const bool mirrored = isMirrored(building.worldFromObject(building.objects[object]));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::size_t corner = i;
    if (mirrored && i % 3 != 0) corner = i % 3 == 1 ? i + 1 : i - 1;
    source[world.indices[world.objects[object].first + corner] - range.first] = indices[i];
  }
  return source;
}

LightPoints makeLightPoints(const Building& building, const WorldGeometry& world) {
  LightPoints points;
  points.of_vertex.resize(world.vertices.size());
  points.vertex_normals.resize(world.vertices.size());
  const AlbedoOf albedo(building);
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
    ObjectPoints(building, world, o, points).make(albedo);
  }
  return points;
}

}  // namespace enfilade
