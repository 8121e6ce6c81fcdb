#include <algorithm>
#include <cmath>
#include <set>

#include "preprocess/tour_film.h"

namespace enfilade {

namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr int kMostRounds = 60;  // of putting poses where lines between them cross something

TourSample sampleAt(const std::vector<TourSample>& samples, double effort) {
  const auto after =
      std::lower_bound(samples.begin(), samples.end(), effort,
                       [](const TourSample& s, double value) { return s.effort < value; });
  if (after == samples.begin()) return samples.front();
  if (after == samples.end()) return samples.back();
  const TourSample& a = *(after - 1);
  const TourSample& b = *after;
  const double span = b.effort - a.effort;
  const auto t = static_cast<float>(span > 0 ? (effort - a.effort) / span : 0.0);
  TourSample out = t < 0.5f ? a : b;
  out.eye = glm::mix(a.eye, b.eye, t);
  out.yaw = glm::mix(a.yaw, b.yaw, t);
  out.pitch = glm::mix(a.pitch, b.pitch, t);
  out.effort = effort;
  return out;
}

// Shares `frames` − 1 steps out to the stretches between keys, at least one to each, so that the
// longest step is as short as can be.
std::vector<int> shareSteps(const std::vector<double>& keys, int frames) {
  std::vector<int> steps(keys.size() - 1, 1);
  const double whole = keys.back() - keys.front();
  const int spare = frames - 1 - static_cast<int>(steps.size());
  int given = 0;
  std::vector<std::pair<double, std::size_t>> longest;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double length = keys[i + 1] - keys[i];
    const int more = whole > 0 ? static_cast<int>(std::floor(spare * length / whole)) : 0;
    steps[i] += more;
    given += more;
    longest.emplace_back(length / steps[i], i);
  }
  std::make_heap(longest.begin(), longest.end());
  for (; given < spare; ++given) {
    std::pop_heap(longest.begin(), longest.end());
    const std::size_t i = longest.back().second;
    ++steps[i];
    longest.back().first = (keys[i + 1] - keys[i]) / steps[i];
    std::push_heap(longest.begin(), longest.end());
  }
  return steps;
}

// The effort of each frame, where every key is one.
std::vector<double> placeFrames(const std::set<double>& key_set, int frames) {
  const std::vector<double> keys(key_set.begin(), key_set.end());
  std::vector<double> at;
  if (keys.size() < 2) {
    at.assign(static_cast<std::size_t>(frames), keys.front());
    return at;
  }
  const std::vector<int> steps = shareSteps(keys, frames);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (int k = 0; k < steps[i]; ++k) {
      at.push_back(keys[i] + (keys[i + 1] - keys[i]) * k / steps[i]);
    }
  }
  at.push_back(keys.back());
  return at;
}

// Without enough frames for all keys: as many as there are, spread evenly.
std::set<double> thinned(const std::set<double>& keys, int frames) {
  const std::vector<double> all(keys.begin(), keys.end());
  if (static_cast<int>(all.size()) <= frames) return keys;
  std::set<double> out;
  for (int i = 0; i < frames; ++i) {
    out.insert(
        all[static_cast<std::size_t>(i) * (all.size() - 1) / static_cast<std::size_t>(frames - 1)]);
  }
  return out;
}

// Adds a key in the middle of each pair of frames whose line crosses something solid.
bool addKeys(const std::vector<TourSample>& samples, const ObstacleBins& obstacles,
             const std::vector<double>& at, std::set<double>& keys) {
  bool added = false;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    if (!obstacles.crosses(sampleAt(samples, at[i]).eye, sampleAt(samples, at[i + 1]).eye)) {
      continue;
    }
    added = keys.insert(0.5 * (at[i] + at[i + 1])).second || added;
  }
  return added;
}

}  // namespace

std::vector<TimedPose> chooseFrames(const std::vector<TourSample>& samples,
                                    const ObstacleBins& obstacles, int frames) {
  std::set<double> keys{samples.front().effort, samples.back().effort};
  for (const TourSample& s : samples) {
    if (s.visit) keys.insert(s.effort);
  }
  keys = thinned(keys, frames);
  std::vector<double> at = placeFrames(keys, frames);
  for (int round = 0; round < kMostRounds; ++round) {
    if (!addKeys(samples, obstacles, at, keys)) break;
    if (static_cast<int>(keys.size()) > frames) break;
    at = placeFrames(keys, frames);
  }
  std::vector<TimedPose> poses;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const TourSample s = sampleAt(samples, at[i]);
    poses.push_back(
        {static_cast<double>(i) / kFramesPerSecond, poseFromAngles(s.eye, s.yaw, s.pitch)});
  }
  return poses;
}

}  // namespace enfilade
