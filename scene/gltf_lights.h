#pragma once

#include <cstdint>
#include <vector>

#include "scene/building.h"
#include "scene/gltf_model.h"

namespace enfilade {

/// Reads the lights (KHR_lights_punctual) of the nodes into `building`; `gltf_nodes` holds the glTF
/// node of each of its nodes.  Numbers that are not finite or out of range become the nearest
/// sensible ones; a light of unknown kind is left out with a warning.  Throws Error (kBadInput): a
/// light that is not there.
void readLights(const GltfModel& gltf, const std::vector<int>& gltf_nodes, Building& building,
                WarningLog& warnings);

}  // namespace enfilade
