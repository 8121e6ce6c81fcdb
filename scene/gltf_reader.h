#pragma once

#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// What a reader noticed and mended, a line each: for `inspect` and for progress.
using Warnings = std::vector<std::string>;

/// Reads a .glb or .gltf (told apart by content).  Triangles only; strips and fans are turned into
/// triangles, points and lines are skipped with a warning; missing normals become flat ones.  A
/// mesh used by many nodes stays shared. External files must lie inside the model's own folder,
/// symbolic links resolved. Throws Error (kBadInput) naming the file: missing, a directory, not
/// glTF, truncated, a required extension that we lack, indices out of range, no triangles.
Building readGltf(const std::string& file, Warnings* warnings = nullptr);

}  // namespace enfilade
