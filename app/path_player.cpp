#include "app/path_player.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace enfilade {

Pose poseAt(const CameraPath& path, double time) {
  assert(!path.poses.empty());
  const auto next = std::upper_bound(path.poses.begin(), path.poses.end(), time,
                                     [](double t, const TimedPose& p) { return t < p.time; });
  if (next == path.poses.begin()) return path.poses.front().pose;
  const auto last = std::prev(next);
  if (next == path.poses.end()) return last->pose;
  const double share = (time - last->time) / (next->time - last->time);
  return interpolate(last->pose, next->pose, static_cast<float>(share));
}

PathPlayer::PathPlayer(CameraPath path, const House& house, const std::string& file)
    : path_(std::move(path)), doors_(path_, house, file) {
  assert(!path_.poses.empty());
}

double PathPlayer::duration() const noexcept {
  return path_.poses.back().time - path_.poses.front().time;
}

Pose PathPlayer::poseAt(double time) const {
  return enfilade::poseAt(path_, path_.poses.front().time + time);
}

const std::vector<std::uint8_t>* PathPlayer::doorsAt(double time) const {
  return doors_.at(path_.poses.front().time + time);
}

}  // namespace enfilade
