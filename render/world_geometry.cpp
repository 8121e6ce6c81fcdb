#include "render/world_geometry.h"

#include <utility>

#include "render/shading.h"
#include "scene/error.h"

namespace enfilade {
namespace {

glm::u8vec4 toBytes(const glm::vec4& color) {
  return glm::u8vec4(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Which vertices of an array an object has used so far, without clearing it for each object.
struct Seen {
  std::vector<std::uint32_t> object;  // the object that last used a vertex
  std::vector<std::uint32_t> vertex;  // its index in the world's vertices then
};

/// Turns the vertices of one object into world vertices.
class ObjectVertices {
 public:
  ObjectVertices(const Building& building, const Object& object)
      : source_(building.vertex_arrays[building.meshOf(object).vertices]),
        base_color_(building.materialOf(object).base_color),
        encoded_base_(encodeTint(base_color_)),
        unlit_(building.materialOf(object).unlit),
        world_from_object_(building.worldFromObject(object)) {
    // The cofactors are the inverse transpose up to the determinant, and are there without one.
    const glm::mat3 m(world_from_object_);
    const float sign = mirrored() ? -1.0f : 1.0f;
    world_from_normal_ = glm::mat3(sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]),
                                   sign * glm::cross(m[0], m[1]));
  }

  bool mirrored() const { return glm::determinant(glm::mat3(world_from_object_)) < 0.0f; }

  WorldVertex at(std::uint32_t i) const {
    WorldVertex v{};
    v.position = glm::vec3(world_from_object_ * glm::vec4(source_.positions[i], 1.0f));
    const glm::vec4 tint = tintAt(i);
    const glm::vec3 normal = normalAt(i);
    const auto shaded = [&](const glm::vec3& n) {
      const float shade = unlit_ ? 1.0f : skyAndSun(n);
      return toBytes(glm::vec4(glm::vec3(tint) * shade, tint.a));
    };
    v.front = shaded(normal);
    v.back = shaded(-normal);
    if (!source_.texcoords.empty()) v.texcoord = source_.texcoords[i];
    return v;
  }

 private:
  glm::vec4 tintAt(std::uint32_t i) const {
    if (source_.colors.empty()) return encoded_base_;
    return encodeTint(base_color_ * (glm::vec4(source_.colors[i]) / 65535.0f));
  }

  glm::vec3 normalAt(std::uint32_t i) const {
    if (source_.normals.empty()) return {0, 1, 0};
    const glm::vec3 normal = world_from_normal_ * source_.normals[i];
    const float length = glm::length(normal);
    return length > 0.0f ? normal / length : glm::vec3(0, 1, 0);
  }

  const VertexArrays& source_;
  glm::vec4 base_color_;
  glm::vec4 encoded_base_;
  bool unlit_;
  glm::mat4 world_from_object_;
  glm::mat3 world_from_normal_;
};

void appendObject(const Building& building, std::uint32_t o, std::vector<Seen>& seen_by_array,
                  WorldGeometry& world) {
  const Object& object = building.objects[o];
  const Mesh& mesh = building.meshOf(object);
  Seen& seen = seen_by_array[mesh.vertices];
  const std::size_t size = building.vertex_arrays[mesh.vertices].positions.size();
  if (seen.object.empty()) {
    seen.object.assign(size, kNone);
    seen.vertex.assign(size, 0);
  }
  const ObjectVertices vertices(building, object);
  const std::size_t first = world.indices.size();
  for (const std::uint32_t i : mesh.indices) {
    if (seen.object[i] != o) {
      seen.object[i] = o;
      seen.vertex[i] = static_cast<std::uint32_t>(world.vertices.size());
      world.vertices.push_back(vertices.at(i));
    }
    world.indices.push_back(seen.vertex[i]);
  }
  if (vertices.mirrored()) {
    for (std::size_t i = first; i + 2 < world.indices.size(); i += 3) {
      std::swap(world.indices[i + 1], world.indices[i + 2]);
    }
  }
  if (world.vertices.size() >= kNone) {
    throw Error(ErrorKind::kMachine, building.name, "has too many vertices to be drawn");
  }
  world.objects.push_back({first, static_cast<std::uint32_t>(mesh.indices.size())});
}

}  // namespace

WorldGeometry worldGeometry(const Building& building) {
  WorldGeometry world;
  world.indices.reserve(3 * triangleCount(building));
  world.objects.reserve(building.objects.size());
  std::vector<Seen> seen(building.vertex_arrays.size());
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
    appendObject(building, o, seen, world);
  }
  return world;
}

}  // namespace enfilade
