#pragma once

#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

#include "scene/gltf_model.h"

namespace enfilade {

/// One animated property of a node: keys and how to go from one to the next.
/// Source: Khronos, glTF 2.0 specification, section 3.11 and appendix C.
struct GltfTrack {
  enum class Interpolation { kStep, kLinear, kCubicSpline };
  Interpolation interpolation = Interpolation::kLinear;
  bool is_rotation = false;       ///< values are unit quaternions, x, y, z, w
  std::vector<float> times;       ///< [s], increasing; at least one
  std::vector<glm::vec4> values;  ///< one a key; for kCubicSpline in-tangent, value, out-tangent

  /// The value at `time`; before the first key the first, behind the last the last.
  glm::dvec4 at(double time) const;
};

/// What animations do to nodes.
class GltfAnimation {
 public:
  /// All channels of all animations that move, turn or scale a node; of two that do the same to a
  /// node the first.  Throws Error (kBadInput): keys that are missing, not finite or not in order.
  explicit GltfAnimation(const GltfModel& gltf);

  bool animates(int gltf_node) const;

  /// A node's own transform at `time` [s].  Throws Error (kBadInput).
  glm::dmat4 parentFromNode(int gltf_node, double time) const;

  /// The first and last key of the tracks of `gltf_nodes` [s]; 0 and 0 without any.
  std::pair<double, double> timeRange(const std::vector<int>& gltf_nodes) const;

 private:
  enum Property { kTranslation, kRotation, kScale };

  const GltfModel& gltf_;
  std::map<std::pair<int, int>, GltfTrack> tracks_;  ///< by node and Property
};

}  // namespace enfilade
