#include "scene/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include "scene/building_repair.h"
#include "scene/camera_path_formats.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_container.h"
#include "scene/json_depth.h"
#include "scene/warning_log.h"

namespace enfilade {
namespace {

using nlohmann::json;

/// Each keeps how all doors of a house stand from then on.
constexpr std::size_t kMostDoorEvents = 10'000;

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, file, reason);
}

/// `N` finite numbers of `frame`, or an error that names them.
template <std::size_t N>
std::array<double, N> numbersOf(const std::string& file, const std::string& place,
                                const json& frame, const char* key) {
  std::array<double, N> numbers{};
  const auto found = frame.find(key);
  const bool is_array = found != frame.end() && found->is_array() && found->size() == N;
  for (std::size_t i = 0; i < N; ++i) {
    if (!is_array || !(*found)[i].is_number()) {
      fail(file, fmt::format("{}: \"{}\" is not {} numbers", place, key, N));
    }
    numbers[i] = (*found)[i];
  }
  return numbers;
}

void readFrame(const std::string& file, std::size_t index, const json& frame, CameraPath& path) {
  const std::string place = fmt::format("frame {}", index);
  if (!frame.is_object()) fail(file, place + " is no object");
  const auto time = frame.find("t");
  if (time == frame.end() || !time->is_number()) fail(file, place + ": \"t\" is no number");
  const auto p = numbersOf<3>(file, place, frame, "p");
  const auto q = numbersOf<4>(file, place, frame, "q");
  TimedPose pose;
  pose.time = *time;
  pose.pose.position = glm::vec3(glm::dvec3(p[0], p[1], p[2]));
  pose.pose.world_from_camera_rotation = glm::quat(glm::dquat(q[3], q[0], q[1], q[2]));
  appendPose(file, place, pose, path);
}

void readDoor(const std::string& file, std::size_t index, const json& door, CameraPath& path) {
  const std::string place = fmt::format("doors[{}]", index);
  const auto member = [&](const char* key) {
    return door.is_object() && door.contains(key) ? door[key] : json();
  };
  if (!member("t").is_number()) fail(file, place + ": \"t\" is no number");
  if (!member("portal").is_string()) fail(file, place + ": \"portal\" is no name");
  if (!member("open").is_boolean()) fail(file, place + ": \"open\" is neither true nor false");
  DoorEvent event{member("t"), member("portal"), member("open")};
  if (!std::isfinite(event.time)) fail(file, place + ": \"t\" is not finite");
  if (!path.doors.empty() && event.time < path.doors.back().time) {
    fail(file, place + " is earlier than the one before it");
  }
  path.doors.push_back(std::move(event));
}

std::string textOfName(const std::string& name) {
  return json(name).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string textOfDoors(const std::vector<DoorEvent>& doors) {
  std::string text;
  for (const DoorEvent& door : doors) {
    text += fmt::format("{}\n{{\"t\":{},\"portal\":{},\"open\":{}}}", text.empty() ? "" : ",",
                        door.time, textOfName(door.portal), door.open);
  }
  return text.empty() ? text : ",\n\"doors\": [" + text + "\n]";
}

std::string textOfPose(const TimedPose& timed, const char* format) {
  const glm::vec3& p = timed.pose.position;
  const glm::quat& q = timed.pose.world_from_camera_rotation;
  return fmt::format(fmt::runtime(format), timed.time, p.x, p.y, p.z, q.x, q.y, q.z, q.w);
}

}  // namespace

void setFieldOfView(const std::string& file, const std::string& place, double degrees,
                    CameraPath& path) {
  constexpr double kLeast = 1, kMost = 170, kRounding = 1e-4;
  if (!(degrees > kLeast - kRounding && degrees < kMost + kRounding)) {
    fail(file,
         fmt::format("{} is {:.4g} degrees, not from {} to {}", place, degrees, kLeast, kMost));
  }
  path.vertical_fov = static_cast<float>(glm::radians(degrees));
}

void appendPose(const std::string& file, const std::string& place, TimedPose pose,
                CameraPath& path) {
  glm::quat& q = pose.pose.world_from_camera_rotation;
  const glm::vec3& p = pose.pose.position;
  const float length = glm::length(q);
  if (!std::isfinite(pose.time) || !std::isfinite(p.x) || !std::isfinite(p.y) ||
      !std::isfinite(p.z) || !std::isfinite(length)) {
    fail(file, place + " has a number that is not finite");
  }
  if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthest) {
    fail(file, place + " is more than 1e12 m from the origin");
  }
  if (length < 1e-6f) fail(file, place + " has no rotation: its quaternion is zero");
  if (std::abs(length - 1.0f) > 1e-6f) q /= length;
  if (!path.poses.empty() && pose.time < path.poses.back().time) {
    fail(file, place + " is earlier than the one before it");
  }
  path.poses.push_back(pose);
}

CameraPath readTour(const std::string& file, const json& root) {
  if (root.value("version", json()) != 1) {
    fail(file, fmt::format("is a tour of version {}; this program reads version 1",
                           oneLine(root.value("version", json("?")).dump(), 20)));
  }
  CameraPath path;
  if (root.contains("name") && root["name"].is_string()) path.name = root["name"];
  if (root.contains("vertical_fov_degrees")) {
    const json& fov = root["vertical_fov_degrees"];
    if (!fov.is_number()) fail(file, "\"vertical_fov_degrees\" is no number");
    setFieldOfView(file, "\"vertical_fov_degrees\"", fov, path);
  }
  const auto frames = root.find("frames");
  if (frames == root.end() || !frames->is_array() || frames->empty()) {
    fail(file, "is a tour without frames");
  }
  for (std::size_t i = 0; i < frames->size(); ++i) readFrame(file, i, (*frames)[i], path);
  if (root.contains("doors")) {
    const json& doors = root["doors"];
    if (!doors.is_array()) fail(file, "\"doors\" is no list");
    if (doors.size() > kMostDoorEvents) {
      fail(file, fmt::format("moves doors {} times; {} at most", doors.size(), kMostDoorEvents));
    }
    for (std::size_t i = 0; i < doors.size(); ++i) readDoor(file, i, doors[i], path);
  }
  return path;
}

Camera cameraAt(const CameraPath& path, std::size_t frame, const Camera& camera) {
  Camera placed = camera;
  placed.pose = path.poses[frame].pose;
  return placed;
}

CameraPath decodeCameraPath(std::span<const std::uint8_t> bytes, const std::string& file,
                            double frames_per_second) {
  if (isGlb(bytes)) return readAnimatedCamera(bytes, file, frames_per_second);
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) fail(file, "is empty");
  if (text[start] != '{' && text[start] != '[') return readTum(file, text);

  requireShallowJson(text, file);
  const json root = json::parse(text, nullptr, false);
  if (root.is_discarded()) fail(file, "seems to be JSON, but is damaged or cut short");
  if (root.is_object() && root.contains("asset")) {
    return readAnimatedCamera(bytes, file, frames_per_second);
  }
  const json kind = root.is_object() ? root.value("enfilade", json()) : json();
  if (kind == "tour") return readTour(file, root);
  fail(file, kind.is_string() ? fmt::format("is an Enfilade \"{}\", not a tour",
                                            oneLine(kind.get<std::string>(), 40))
                              : "is JSON, but neither a tour nor glTF");
}

CameraPath readCameraPath(const std::string& file, double frames_per_second) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 30;  // [bytes]: some million poses
  return decodeCameraPath(readFile(file, kMost), file, frames_per_second);
}

void writeCameraPath(const std::string& file, const CameraPath& path) {
  std::string text = fmt::format(
      "{{\n\"enfilade\": \"tour\",\n\"version\": 1,\n\"name\": {},\n\"vertical_fov_degrees\": {},\n"
      "\"frames\": [",
      textOfName(path.name), glm::degrees(static_cast<double>(path.vertical_fov)));
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    text += textOfPose(path.poses[i], R"({{"t":{},"p":[{},{},{}],"q":[{},{},{},{}]}})");
  }
  writeFileAtomically(file, text + "\n]" + textOfDoors(path.doors) + "\n}\n");
}

void writeTumPath(const std::string& file, const CameraPath& path) {
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const TimedPose& pose : path.poses) text += textOfPose(pose, "{} {} {} {} {} {} {} {}\n");
  writeFileAtomically(file, text);
}

PathFormat pathFormatOf(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".tum" || extension == ".txt") return PathFormat::kTum;
  if (extension == ".gltf" || extension == ".glb") return PathFormat::kGltf;
  return PathFormat::kTour;
}

void writePath(const std::string& file, const CameraPath& path, PathFormat format) {
  if (format == PathFormat::kTum) return writeTumPath(file, path);
  if (format == PathFormat::kGltf) return writeGltfPath(file, path);
  writeCameraPath(file, path);
}

}  // namespace enfilade
