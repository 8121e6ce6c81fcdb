#include "app/path_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade {

namespace {

constexpr double kLongestGlide = 0.25;  // [s] from one frame to the next
constexpr double kRounding = 1e-9;      // [s] by which a clock may miss the time of a pose

bool isUsable(double time, const Pose& pose) {
  const glm::vec3& p = pose.position;
  const float turn = glm::length(pose.world_from_camera_rotation);
  return std::isfinite(time) && std::isfinite(p.x + p.y + p.z) && std::isfinite(turn) &&
         turn > 1e-6f;
}

}  // namespace

PathRecorder::PathRecorder(RecorderParameters parameters) : parameters_(std::move(parameters)) {
  path_.name = parameters_.name;
  path_.vertical_fov = parameters_.vertical_fov;
}

bool PathRecorder::addFrame(double time, const Pose& pose) {
  if (full_) return false;
  if (!isUsable(time, pose)) return true;
  Frame frame{begin_ ? time - *begin_ : 0, pose};
  glm::quat& q = frame.pose.world_from_camera_rotation;
  q = glm::normalize(q);
  if (!begin_) {
    begin_ = time;
    last_ = frame;
    path_.poses.push_back({0, frame.pose});
    return true;
  }
  if (frame.time < last_.time) return true;
  if (glm::dot(q, last_.pose.world_from_camera_rotation) < 0) q = -q;
  resampleTo(frame);
  last_ = frame;
  full_ = frame.time > parameters_.longest;
  return !full_;
}

// Appends the poses since the last frame; those after `longest` are left out.
void PathRecorder::resampleTo(const Frame& frame) {
  const double start = std::max(last_.time, frame.time - kLongestGlide);
  for (;;) {
    const double time = static_cast<double>(path_.poses.size()) / parameters_.frames_per_second;
    if (time > std::min(frame.time, parameters_.longest) + kRounding) return;
    const double length = frame.time - start;
    const double share = length > 0 ? std::clamp((time - start) / length, 0.0, 1.0) : 1.0;
    Pose pose = interpolate(last_.pose, frame.pose, static_cast<float>(share));
    glm::quat& q = pose.world_from_camera_rotation;
    const Pose& before = path_.poses.back().pose;
    if (glm::dot(q, before.world_from_camera_rotation) < 0) q = -q;
    path_.poses.push_back({time, pose});
  }
}

void PathRecorder::addDoor(double time, const std::string& portal, bool open) {
  if (full_ || !std::isfinite(time)) return;
  double at = begin_ ? std::max(0.0, time - *begin_) : 0.0;
  if (at > parameters_.longest) return;
  if (!path_.doors.empty()) at = std::max(at, path_.doors.back().time);
  path_.doors.push_back({at, portal, open});
}

void PathRecorder::addDoors(double time, std::span<const std::uint8_t> open) {
  for (std::size_t p = 0; p < std::min(open.size(), open_.size()); ++p) {
    if ((open[p] != 0) != (open_[p] != 0)) addDoor(time, fmt::format("{}", p), open[p] != 0);
  }
  open_.assign(open.begin(), open.end());
}

double PathRecorder::duration() const noexcept {
  return begin_ ? std::min(last_.time, parameters_.longest) : 0.0;
}

}  // namespace enfilade
