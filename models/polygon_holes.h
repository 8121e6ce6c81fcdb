#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace enfilade {

/// A corner of a polygon that its holes were joined to.
struct JoinedCorner {
  std::size_t index = 0;  ///< the outer polygon's corners first, then each hole's in order
  glm::dvec2 point{0};
};

/// One outline, of which holes are bays: each is joined by the shortest cut, gone both ways, that
/// meets no edge.  `outer` and `holes` of positive area, holes inside and apart.
/// Source: Eberly, Triangulation by Ear Clipping, 2002, section 3.
std::vector<JoinedCorner> joinHoles(const std::vector<glm::dvec2>& outer,
                                    const std::vector<std::vector<glm::dvec2>>& holes);

}  // namespace enfilade
