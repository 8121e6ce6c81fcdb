#pragma once

#include "app/report.h"
#include "portals/house.h"
#include "scene/camera_path.h"

namespace enfilade {

/// Fills in what a report says of the house: counts, the model, its parameters.
void describeHouse(const House& house, Report& report);

/// Fills in what a report says of the path: its frames, what it is known by, and the plan with it.
void describePath(const House& house, const CameraPath& path, Report& report);

/// SHA-256 of the poses and the doors: equal for walks that pass the same places, whatever their
/// files are called.
std::string pathSha256(const CameraPath& path);

}  // namespace enfilade
