#pragma once

#include <string>

#include "portals/cell_graph.h"
#include "scene/building.h"
#include "scene/camera_path.h"

namespace enfilade::fuzz {

/// Throws std::logic_error that says `what` unless it holds: for what a reader promises.
void require(bool holds, const std::string& what);

/// That a message for a person is one line, without anything that would move a terminal's cursor.
void requireOneLine(const std::string& message);

/// That whoever draws a building may trust it: every index is in range, every array as long as it
/// should be, all numbers finite, normals of unit length.
void requireSound(const Building& building);

/// That cells and portals name cells and portals that are there, and that all numbers are finite.
void requireSound(const CellGraph& graph);

/// That a path has poses, in order, with finite places and unit rotations.
void requireSound(const CameraPath& path);

}  // namespace enfilade::fuzz
