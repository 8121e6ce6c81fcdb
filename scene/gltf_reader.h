#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// What a reader noticed and mended, a line each: for `inspect` and for progress.
using Warnings = std::vector<std::string>;

/// Reads a .glb or .gltf, told apart by content: the file's default scene, else its scene 0, else
/// all its nodes.  Nodes come parents first, otherwise in the file's order, empties included; an
/// object for every primitive of every node, in the order of the nodes (or in that of the building
/// that writeGlb wrote).  A mesh used by many nodes stays shared, and so do vertices named by many
/// primitives.
///
/// Triangles only: strips and fans are turned into triangles, points and lines are left out, and so
/// are pictures that are missing or neither PNG nor JPEG; missing normals become flat ones; skins
/// and morph targets are ignored.  Each with a warning.  Of the extensions it knows
/// KHR_texture_transform, KHR_mesh_quantization, KHR_materials_unlit, KHR_lights_punctual and the
/// diffuse colour of KHR_materials_pbrSpecularGlossiness.  External files must lie inside the
/// model's own folder, symbolic links resolved.
///
/// Throws Error (kBadInput) naming the file: missing, a directory, not glTF 2.0, truncated, a
/// required extension that we lack, indices out of range, nodes below themselves, no triangles.
Building readGltf(const std::string& file, Warnings* warnings = nullptr);

/// The same of the bytes of `file`, which need not be there: what they name is looked for beside
/// it.
Building decodeGltf(std::span<const std::uint8_t> bytes, const std::string& file,
                    Warnings* warnings = nullptr);

}  // namespace enfilade
