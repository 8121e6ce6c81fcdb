#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/camera.h"

namespace enfilade {

struct TimedPose {
  double time = 0;  ///< [s], not decreasing along a path
  Pose pose;
};

/// What happens to doors along a path.
struct DoorEvent {
  double time = 0;     ///< [s], not decreasing along a path
  std::string portal;  ///< the doors' portals: name, number or pattern
  bool open = true;    ///< from then on
};

/// A scripted walk: one pose a frame.
struct CameraPath {
  std::string name;
  float vertical_fov = 1.047f;  ///< [rad] of 1° to 170°
  std::vector<TimedPose> poses;
  std::vector<DoorEvent> doors;
};

/// `camera` with the pose of the path's frame `frame`.
Camera cameraAt(const CameraPath& path, std::size_t frame, const Camera& camera);

/// Reads a path, at least one pose.  By content, whatever the extension:
/// - our JSON: {"enfilade": "tour", "version": 1, "name": …, "vertical_fov_degrees": …,
///   "frames": [{"t": seconds, "p": [x, y, z], "q": [x, y, z, w]}, …]}, and perhaps
///   "doors": [{"t": seconds, "portal": name, "open": true or false}, …];
/// - TUM: lines of `timestamp tx ty tz qx qy qz qw`, `#` comments.  Rotations as here, a camera
/// that
///   looks down its −Z; the format has no field of view, so it stays the default;
/// - glTF or GLB: the first perspective camera that is animated, itself or by a node above it,
///   sampled `frames_per_second` times a second from the first key on, which becomes time 0.
/// Rotations are normalised.  Throws Error (kBadInput) that says what the file seems to be, or
/// which frame or line is wrong.
CameraPath readCameraPath(const std::string& file, double frames_per_second = 30.0);

/// The same of the bytes of `file`.
CameraPath decodeCameraPath(std::span<const std::uint8_t> bytes, const std::string& file,
                            double frames_per_second = 30.0);

/// Writes our JSON, by way of a temporary name: reading it gives the same path.  Throws Error
/// (kMachine).
void writeCameraPath(const std::string& file, const CameraPath& path);

/// Writes TUM lines, without doors, by way of a temporary name.  Throws Error (kMachine).
void writeTumPath(const std::string& file, const CameraPath& path);

/// Writes an animated glTF camera, without doors, by way of a temporary name: text with its numbers
/// inside if the file's name ends in .gltf, or else a GLB.  Its times begin at 0; of poses at one
/// time the last is kept.  `path` has poses.  Throws Error (kMachine).
/// Source: Khronos, glTF 2.0 specification, sections 3.10 and 3.11.
void writeGltfPath(const std::string& file, const CameraPath& path);

enum class PathFormat : std::uint8_t { kTour, kTum, kGltf };

/// By its extension: .tum and .txt, .gltf and .glb; or else our JSON.
PathFormat pathFormatOf(const std::string& file);

/// Writes `path` as one of these.
void writePath(const std::string& file, const CameraPath& path, PathFormat format);

}  // namespace enfilade
