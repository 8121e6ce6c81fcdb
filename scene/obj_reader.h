#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/building.h"
#include "scene/gltf_reader.h"

namespace enfilade {

/// Fetches what an OBJ names (material libraries, pictures); nothing if it is not there.
using ObjResources =
    std::function<std::optional<std::vector<std::uint8_t>>(const std::string& name)>;

/// Reads a Wavefront OBJ in memory: a node for every object or group, in the file's order, and an
/// object for each material in it.  Metres, +Y up.  Polygons become triangles, missing normals flat
/// ones.  Of materials it knows Kd, d and Tr, map_Kd and map_d; colours are sRGB, both sides of a
/// face are drawn.  What it leaves out is a warning: lines and points, pictures that are missing or
/// neither PNG nor JPEG, faces with corners that are not there.  `file` names it in errors and
/// gives the building its name.  Throws Error (kBadInput).
Building parseObj(std::span<const std::uint8_t> text, const std::string& file,
                  const ObjResources& resources, Warnings* warnings = nullptr);

/// Reads a .obj.  What it names is looked for where it says, inside its own folder alone (symbolic
/// links resolved), and then beside it.  Throws Error (kBadInput).
Building readObj(const std::string& file, Warnings* warnings = nullptr);

/// Whether text looks like an OBJ: its first line that is no comment begins with one of its words.
bool looksLikeObj(std::span<const std::uint8_t> text);

}  // namespace enfilade
