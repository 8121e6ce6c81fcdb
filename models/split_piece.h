#pragma once

#include <span>

#include "scene/tessellate.h"

namespace enfilade {

/// Splits the large faces of a piece's meshes, so that they can carry baked light.
inline void splitPiece(Building& building, std::span<const std::uint32_t> meshes,
                       const glm::mat4& world_from_piece) {
  constexpr std::size_t kMostAdded = 20'000;  // triangles
  constexpr float kEdge = 0.5f;               // [m] furniture is small, and there is much
  std::vector<MeshToSplit> wanted;
  for (const std::uint32_t mesh : meshes) wanted.push_back({mesh, world_from_piece});
  splitLongEdges(building, wanted, kEdge, kMostAdded);
}

}  // namespace enfilade
