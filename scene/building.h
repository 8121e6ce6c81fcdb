#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

#include "scene/geometry.h"
#include "scene/image.h"
#include "scene/light.h"

namespace enfilade {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Vertices that one or several meshes index.  Every non-empty array has one element a vertex.
struct VertexArrays {
  std::vector<glm::vec3> positions;  ///< object space [m]
  std::vector<glm::vec3> normals;    ///< object space, unit; always there
  std::vector<glm::vec2> texcoords;  ///< transforms applied; empty only if no picture needs it
  std::vector<glm::u16vec4> colors;  ///< COLOR_0, linear, 65535 is 1; may be empty
};

/// Triangles of one material: a glTF primitive, or a part of one.
struct Mesh {
  std::string name;
  std::uint32_t vertices = kNone;        ///< index in Building::vertex_arrays
  std::uint32_t material = 0;            ///< index in Building::materials
  std::vector<std::uint32_t> indices{};  ///< three a triangle
  Box bounds{};                          ///< of the indexed vertices, object space
};

enum class AlphaMode : std::uint8_t { kOpaque, kMask, kBlend };
enum class Wrap : std::uint8_t { kRepeat, kClampToEdge, kMirroredRepeat };

struct Material {
  std::string name;
  glm::vec4 base_color{1};      ///< linear RGB and alpha, 0…1; kOpaque ignores the alpha
  std::uint32_t image = kNone;  ///< base colour texture: index in Building::images
  Wrap wrap_s = Wrap::kRepeat;
  Wrap wrap_t = Wrap::kRepeat;
  bool nearest_filter = false;  ///< magnification by nearest texel
  AlphaMode alpha_mode = AlphaMode::kOpaque;
  float alpha_cutoff = 0.5f;  ///< of kMask
  bool double_sided = false;  ///< otherwise back faces are not drawn
  bool unlit = false;         ///< no sky and sun term
};

/// A node of the glTF scene, transforms already multiplied through.
struct Node {
  std::string name;
  std::uint32_t parent = kNone;  ///< index in Building::nodes, less than this node's own
  glm::mat4 world_from_node{1};
  std::string extras{};  ///< the JSON text of `extras.enfilade`; empty without one
};

/// A mesh placed in the world.  Meshes may be shared by many objects.  Where the object's
/// world_from_node mirrors (isMirrored), its front faces are the clockwise ones (glTF 2.0, 3.7.4):
/// whoever draws or splits it turns each triangle round.  Normals go by the inverse transpose and
/// are right as they are.
struct Object {
  std::uint32_t node = kNone;  ///< index in Building::nodes: its name and world_from_node
  std::uint32_t mesh = kNone;  ///< index in Building::meshes
};

/// A building in memory: metres, right-handed, +Y up.  Objects are drawn in the order in which they
/// stand here.
struct Building {
  std::string name;
  std::string copyright;  ///< asset.copyright
  std::vector<VertexArrays> vertex_arrays;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<TextureImage> images;
  std::vector<Node> nodes;
  std::vector<Object> objects;
  std::vector<Light> lights;

  const glm::mat4& worldFromObject(const Object& object) const {
    return nodes[object.node].world_from_node;
  }
  const Mesh& meshOf(const Object& object) const { return meshes[object.mesh]; }
  const Material& materialOf(const Object& object) const {
    return materials[meshes[object.mesh].material];
  }
};

/// Whether a transform turns counter-clockwise triangles clockwise: its determinant is negative.
inline bool isMirrored(const glm::mat4& m) { return glm::determinant(glm::mat3(m)) < 0.0f; }

/// Bounds of an object in the world [m]: of its vertices, not of its transformed box.
Box worldBounds(const Building& building, const Object& object);

/// Bounds of all objects in the world [m]; empty without any.
Box worldBounds(const Building& building);

/// Triangles over all objects, shared meshes counted once for each object.
std::size_t triangleCount(const Building& building);

/// One flag an object: whether one of `patterns` (shell wildcards * and ?, case-sensitive, joined
/// by commas) matches the name of the object's node, of one of the node's ancestors, or of its
/// material.
std::vector<std::uint8_t> matchNames(const Building& building, const std::string& patterns);

}  // namespace enfilade
