#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "scene/building.h"
#include "scene/glb_buffer.h"

namespace enfilade {

/// glTF accessors of a building's geometry, -1 for what it has not or what no object uses.
struct GeometryAccessors {
  struct Vertices {
    int position = -1;
    int normal = -1;
    int texcoord = -1;
    int color = -1;
  };
  std::vector<Vertices> vertices;  ///< one a Building::vertex_arrays
  std::vector<int> indices;        ///< one a Building::meshes
};

/// Appends the vertices and indices that objects use to `buffer`, their accessors and buffer views
/// to `root`.
GeometryAccessors writeGeometry(const Building& building, nlohmann::ordered_json& root,
                                GlbBuffer& buffer);

/// Appends all images to `buffer`, all materials with their textures and samplers to `root`.
void writeMaterials(const Building& building, nlohmann::ordered_json& root, GlbBuffer& buffer);

/// Writes the lights to `root`, whose nodes are there already.  A node has one light.
void writeLights(const Building& building, nlohmann::ordered_json& root);

/// Appends a buffer view, without `target` or `stride` if they are 0.  Returns its index.
int addBufferView(nlohmann::ordered_json& root, std::size_t offset, std::size_t length, int target,
                  std::size_t stride);

}  // namespace enfilade
