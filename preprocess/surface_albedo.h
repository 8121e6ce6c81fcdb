#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// What share of the light that falls on a surface comes back from it: base colour × the mean of
/// its picture × vertex colour, linear, at most 0.9.  Paler than the surface is, half way to grey
/// of the same luminance: eyes adapt to the cast that a lawn throws on a ceiling, a vertex colour
/// does not.
class AlbedoOf {
 public:
  /// Keeps a reference to `building`.
  explicit AlbedoOf(const Building& building);

  /// At vertex `vertex` of the arrays of an object's mesh.
  glm::vec3 at(std::uint32_t object, std::uint32_t vertex) const;

 private:
  const Building& building_;
  std::vector<glm::vec3> of_material_;
};

}  // namespace enfilade
