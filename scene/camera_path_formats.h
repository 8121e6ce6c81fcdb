#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "scene/camera_path.h"

namespace enfilade {

/// One reader a format of camera path; `file` is for errors.  All throw Error (kBadInput).
CameraPath readTour(const std::string& file, const nlohmann::json& root);
CameraPath readTum(const std::string& file, std::string_view text);
CameraPath readAnimatedCamera(std::span<const std::uint8_t> bytes, const std::string& file,
                              double frames_per_second);

/// Sets the vertical field of view [degrees].  Throws if it is not from 1 to 170; `place` names it.
void setFieldOfView(const std::string& file, const std::string& place, double degrees,
                    CameraPath& path);

/// Appends a pose: checks that its numbers are finite, its rotation is one and its time is not
/// before the last, and normalises the rotation.  `place` names it in errors: "frame 7".
void appendPose(const std::string& file, const std::string& place, TimedPose pose,
                CameraPath& path);

}  // namespace enfilade
