#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// A corner of a triangle while a mesh is being raised.
struct Corner {
  glm::dvec3 position{0};  ///< [m]
  glm::dvec2 texcoord{0};
  double shade = 1;  ///< vertex colour, 0…1, grey
};

/// Gathers the triangles of one mesh.
class MeshBuilder {
 public:
  /// Everything added from now on is moved by `m` (rotations and translations only).
  void setTransform(const glm::dmat4& m) { transform_ = m; }
  /// Everything added from now on is tinted by `color` (linear).
  void setTint(const glm::dvec3& color) { tint_ = color; }

  std::uint32_t vertex(const Corner& corner, const glm::dvec3& normal);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  /// Flat faces, counter-clockwise as seen from where they show.
  void flatTriangle(const Corner& a, const Corner& b, const Corner& c);
  void flatQuad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);

  /// A box from `low` to `high`; `faces` holds one of "xXyYzZ" for each side that shows, the
  /// capital the greater.  Texture coordinates in metres / `texture_size`.
  void box(const glm::dvec3& low, const glm::dvec3& high, const std::string& faces,
           double texture_size = 1);

  std::size_t triangleCount() const { return indices_.size() / 3; }

  /// Moves the mesh into the building; returns its index there.  Without `shaded` the corners'
  /// shades are left out.
  std::uint32_t addTo(Building& building, const std::string& name, std::uint32_t material,
                      bool shaded = true);

 private:
  VertexArrays vertices_;
  std::vector<glm::u16vec4> unshaded_;  // the tints alone
  std::vector<std::uint32_t> indices_;
  glm::dmat4 transform_{1};
  glm::dvec3 tint_{1};
};

}  // namespace enfilade
