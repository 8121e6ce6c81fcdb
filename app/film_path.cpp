#include "app/film_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/error.h"

namespace enfilade {

namespace {

constexpr double kMostFrames = 1e6;

Pose poseAt(const std::vector<TimedPose>& poses, double time) {
  const auto next = std::upper_bound(poses.begin(), poses.end(), time,
                                     [](double t, const TimedPose& pose) { return t < pose.time; });
  if (next == poses.end()) return poses.back().pose;
  if (next == poses.begin()) return poses.front().pose;
  const TimedPose& before = *std::prev(next);
  const double share = (time - before.time) / (next->time - before.time);
  return share > 0 ? interpolate(before.pose, next->pose, static_cast<float>(share)) : before.pose;
}

}  // namespace

CameraPath filmPath(const CameraPath& path, int frames_per_second, const std::string& file) {
  const double start = path.poses.front().time;
  const double seconds = path.poses.back().time - start;
  if (seconds <= 0) return path;
  // Times are rounded, so that the last frame may come a little after the last pose.
  const double steps = std::floor(seconds * frames_per_second + 1e-3);
  if (steps + 1 > kMostFrames) {
    throw Error(ErrorKind::kBadInput, file,
                fmt::format("lasts {:.9g} s by the times of its poses: {:.9g} frames at {} a "
                            "second are too many for a film",
                            seconds, steps + 1, frames_per_second));
  }
  CameraPath film = path;
  film.poses.clear();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i) {
    const double time = start + static_cast<double>(i) / frames_per_second;
    film.poses.push_back({time, poseAt(path.poses, time)});
  }
  return film;
}

}  // namespace enfilade
