#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "scene/building.h"

namespace enfilade {

/// A mesh to be split and the transform by which its edges are measured.
struct MeshToSplit {
  std::uint32_t mesh = kNone;  ///< index in Building::meshes
  glm::mat4 world_from_mesh{1};
};

/// Splits every triangle edge longer than `longest` [m, > 0, in the world] in its middle until none
/// is, so that vertex colours can carry what changes over a large face.  Attributes are
/// interpolated, normals made unit.  Whether an edge is split, and where, depends on its two ends
/// alone: faces that share an edge still share all of it, of other meshes too.  If that would add
/// more than `most_added` triangles, `longest` is doubled until it does not.  The same on every
/// run.  Returns the length that was kept to.
/// Source: Rivara, Algorithms for refining triangular grids suitable for adaptive and multigrid
/// techniques, 1984: bisection of the longest edge, which keeps triangles from growing thin.
float splitLongEdges(Building& building, std::span<const MeshToSplit> meshes, float longest,
                     std::size_t most_added);

/// The same for the meshes of all objects, each measured where its object is largest; a million
/// triangles may be added, or as many as there are.
float splitLongEdges(Building& building, float longest);

}  // namespace enfilade
