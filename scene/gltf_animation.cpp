#include "scene/gltf_animation.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf_accessors.h"
#include "scene/gltf_nodes.h"

namespace enfilade {
namespace {

glm::dvec4 normalizedOrIdentity(const glm::dvec4& q) {
  const double length = glm::length(q);
  return length > 0.0 ? q / length : glm::dvec4(0, 0, 0, 1);
}

glm::dvec4 slerp(const glm::dvec4& a, const glm::dvec4& b, double t) {
  const auto toQuat = [](const glm::dvec4& v) { return glm::dquat(v.w, v.x, v.y, v.z); };
  const glm::dquat q =
      glm::slerp(toQuat(normalizedOrIdentity(a)), toQuat(normalizedOrIdentity(b)), t);
  return {q.x, q.y, q.z, q.w};
}

GltfTrack::Interpolation interpolationOf(const GltfModel& gltf, const std::string& name) {
  if (name == "LINEAR" || name.empty()) return GltfTrack::Interpolation::kLinear;
  if (name == "STEP") return GltfTrack::Interpolation::kStep;
  if (name == "CUBICSPLINE") return GltfTrack::Interpolation::kCubicSpline;
  gltf.fail("is no valid glTF: an animation interpolates by \"" + oneLine(name, 40) + "\"");
}

void checkTrack(const GltfModel& gltf, const GltfTrack& track) {
  const bool cubic = track.interpolation == GltfTrack::Interpolation::kCubicSpline;
  if (track.times.empty() || track.values.size() != track.times.size() * (cubic ? 3 : 1)) {
    gltf.fail("is no valid glTF: an animation has not as many values as keys");
  }
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    if (!std::isfinite(track.times[i]) || (i > 0 && track.times[i] <= track.times[i - 1])) {
      gltf.fail("is no valid glTF: the keys of an animation are not in order");
    }
  }
  for (const glm::vec4& v : track.values) {
    if (!std::isfinite(v.x + v.y + v.z + v.w)) {
      gltf.fail("is no valid glTF: an animation has a value that is not finite");
    }
  }
}

GltfTrack readTrack(const GltfModel& gltf, const tinygltf::AnimationSampler& sampler,
                    bool is_rotation) {
  GltfTrack track;
  track.interpolation = interpolationOf(gltf, sampler.interpolation);
  track.is_rotation = is_rotation;
  track.times = readScalars(gltf, sampler.input);
  if (is_rotation) {
    track.values = readVec4s(gltf, sampler.output);
  } else {
    for (const glm::vec3& v : readVec3s(gltf, sampler.output)) track.values.emplace_back(v, 0.0f);
  }
  checkTrack(gltf, track);
  return track;
}

}  // namespace

glm::dvec4 GltfTrack::at(double time) const {
  const bool cubic = interpolation == Interpolation::kCubicSpline;
  const auto value = [&](std::size_t key) {
    const glm::dvec4 v(values[cubic ? 3 * key + 1 : key]);
    return is_rotation ? normalizedOrIdentity(v) : v;
  };
  if (time <= times.front()) return value(0);
  if (time >= times.back()) return value(times.size() - 1);
  const auto after = std::upper_bound(times.begin(), times.end(), time,
                                      [](double t, float key) { return t < key; });
  const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
  if (interpolation == Interpolation::kStep) return value(k);
  const double span = static_cast<double>(times[k + 1]) - static_cast<double>(times[k]);
  const double t = (time - static_cast<double>(times[k])) / span;
  if (!cubic) {
    return is_rotation ? slerp(value(k), value(k + 1), t) : glm::mix(value(k), value(k + 1), t);
  }
  const glm::dvec4 out_tangent = span * glm::dvec4(values[3 * k + 2]);
  const glm::dvec4 in_tangent = span * glm::dvec4(values[3 * (k + 1)]);
  const double t2 = t * t;
  const double t3 = t2 * t;
  const glm::dvec4 v = (2 * t3 - 3 * t2 + 1) * glm::dvec4(values[3 * k + 1]) +
                       (t3 - 2 * t2 + t) * out_tangent +
                       (3 * t2 - 2 * t3) * glm::dvec4(values[3 * k + 4]) + (t3 - t2) * in_tangent;
  return is_rotation ? normalizedOrIdentity(v) : v;
}

GltfAnimation::GltfAnimation(const GltfModel& gltf) : gltf_(gltf) {
  for (const tinygltf::Animation& animation : gltf->animations) {
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      const Property property = channel.target_path == "rotation" ? kRotation
                                : channel.target_path == "scale"  ? kScale
                                                                  : kTranslation;
      if (channel.target_node < 0) continue;
      if (property == kTranslation && channel.target_path != "translation") continue;
      const std::pair<int, int> key(channel.target_node, property);
      if (tracks_.contains(key)) continue;
      if (channel.sampler < 0 ||
          static_cast<std::size_t>(channel.sampler) >= animation.samplers.size()) {
        gltf.fail("is no valid glTF: an animation lacks a sampler");
      }
      tracks_[key] = readTrack(gltf, animation.samplers[static_cast<std::size_t>(channel.sampler)],
                               property == kRotation);
    }
  }
}

bool GltfAnimation::animates(int gltf_node) const {
  const auto track = tracks_.lower_bound({gltf_node, kTranslation});
  return track != tracks_.end() && track->first.first == gltf_node;
}

glm::dmat4 GltfAnimation::parentFromNode(int gltf_node, double time) const {
  const glm::dmat4 at_rest = enfilade::parentFromNode(gltf_, gltf_node);
  if (!animates(gltf_node)) return at_rest;
  const tinygltf::Node& node = gltf_->nodes[static_cast<std::size_t>(gltf_node)];
  if (!node.matrix.empty()) {
    gltf_.fail(fmt::format("is no valid glTF: node {} '{}' is animated but has a matrix", gltf_node,
                           oneLine(node.name)));
  }
  const auto value = [&](Property property, const std::vector<double>& own, glm::dvec4 otherwise) {
    const auto track = tracks_.find({gltf_node, property});
    if (track != tracks_.end()) return track->second.at(time);
    for (std::size_t i = 0; i < own.size(); ++i) {
      otherwise[static_cast<glm::length_t>(i)] = own[i];
    }
    return otherwise;
  };
  return composeTransform(glm::dvec3(value(kTranslation, node.translation, glm::dvec4(0))),
                          value(kRotation, node.rotation, glm::dvec4(0, 0, 0, 1)),
                          glm::dvec3(value(kScale, node.scale, glm::dvec4(1))));
}

std::pair<double, double> GltfAnimation::timeRange(const std::vector<int>& gltf_nodes) const {
  std::pair<double, double> range(0.0, 0.0);
  bool first = true;
  for (const auto& [key, track] : tracks_) {
    if (std::find(gltf_nodes.begin(), gltf_nodes.end(), key.first) == gltf_nodes.end()) continue;
    const auto begin = static_cast<double>(track.times.front());
    const auto end = static_cast<double>(track.times.back());
    range.first = first ? begin : std::min(range.first, begin);
    range.second = first ? end : std::max(range.second, end);
    first = false;
  }
  return range;
}

}  // namespace enfilade
