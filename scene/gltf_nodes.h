#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/gltf_model.h"

namespace enfilade {

/// The nodes of a scene, parents before children, otherwise in the file's order.
struct GltfNodeTree {
  struct Entry {
    int gltf_node = -1;
    std::uint32_t parent = 0xffffffffu;  ///< index in `entries`, less than this entry's own
  };
  std::vector<Entry> entries;
};

/// The nodes of the file's default scene, else of its scene 0, else all of them.  Throws Error
/// (kBadInput): a node that is not there, below itself, or the child of two.
GltfNodeTree readNodeTree(const GltfModel& gltf);

/// A node's own transform.  Throws Error (kBadInput): the wrong number of values, not finite.
glm::dmat4 parentFromNode(const GltfModel& gltf, int gltf_node);

/// Translation, then rotation (normalised), then scale, as glTF multiplies them.
glm::dmat4 composeTransform(const glm::dvec3& translation, const glm::dvec4& rotation_xyzw,
                            const glm::dvec3& scale);

/// world_from_parent · parent_from_node, with elements that are nothing but rounding set to zero.
/// Reader and writer use the same, so that a transform comes back as it was.
glm::dmat4 multiplyThrough(const glm::dmat4& world_from_parent, const glm::dmat4& parent_from_node);

}  // namespace enfilade
