#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>

#include "scene/camera_path_formats.h"
#include "scene/error.h"
#include "scene/gltf_animation.h"
#include "scene/gltf_nodes.h"

namespace enfilade {
namespace {

/// Nine hours at 30 frames a second of a camera on its own; more than that is a damaged file.
constexpr double kMaxFrames = 1'000'000;
/// Frames times the nodes that the camera hangs from.
constexpr double kMaxTransforms = 4 * kMaxFrames;

struct AnimatedCamera {
  const tinygltf::Camera* camera = nullptr;
  std::vector<int> chain;  ///< the camera's node and those above it, glTF node indices
};

const tinygltf::Camera& cameraAt(const GltfModel& gltf, int camera) {
  if (static_cast<std::size_t>(camera) >= gltf->cameras.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no camera {}", camera));
  }
  return gltf->cameras[static_cast<std::size_t>(camera)];
}

AnimatedCamera findCamera(const GltfModel& gltf, const GltfAnimation& animation) {
  const GltfNodeTree tree = readNodeTree(gltf);
  bool any_camera = false;
  std::vector<bool> animated;  // the entry or one above it; those come first
  for (std::size_t e = 0; e < tree.entries.size(); ++e) {
    const std::uint32_t parent = tree.entries[e].parent;
    animated.push_back((parent < e && animated[parent]) ||
                       animation.animates(tree.entries[e].gltf_node));
    const int index = gltf->nodes[static_cast<std::size_t>(tree.entries[e].gltf_node)].camera;
    if (index < 0 || cameraAt(gltf, index).type != "perspective") continue;
    any_camera = true;
    if (!animated[e]) continue;
    AnimatedCamera found{&cameraAt(gltf, index), {}};
    for (auto i = static_cast<std::uint32_t>(e); i < tree.entries.size();
         i = tree.entries[i].parent) {
      found.chain.push_back(tree.entries[i].gltf_node);
    }
    return found;
  }
  gltf.fail(any_camera ? "holds a camera, but no animation of it"
                       : "is glTF without a perspective camera, so it is no camera path");
}

/// Where the camera stands and looks; glTF ignores the scale of a camera's node.
Pose poseOf(const glm::dmat4& world_from_camera) {
  const glm::dvec3 back = glm::normalize(glm::dvec3(world_from_camera[2]));
  const glm::dvec3 y(world_from_camera[1]);
  const glm::dvec3 up = glm::normalize(y - glm::dot(y, back) * back);
  const glm::dmat3 rotation(glm::cross(up, back), up, back);
  return {glm::vec3(world_from_camera[3]), glm::quat(glm::normalize(glm::quat_cast(rotation)))};
}

}  // namespace

CameraPath readAnimatedCamera(std::span<const std::uint8_t> bytes, const std::string& file,
                              double frames_per_second) {
  assert(frames_per_second > 0.0);
  WarningLog ignored;
  const GltfModel gltf = loadGltfModel(bytes, file, ignored);
  const GltfAnimation animation(gltf);
  const AnimatedCamera camera = findCamera(gltf, animation);

  CameraPath path;
  path.name = gltf->nodes[static_cast<std::size_t>(camera.chain.front())].name;
  if (path.name.empty()) path.name = std::filesystem::path(file).stem().string();
  setFieldOfView(file, "the yfov of its camera", glm::degrees(camera.camera->perspective.yfov),
                 path);

  const auto [begin, end] = animation.timeRange(camera.chain);
  // A hair more, so that rounding, of keys in 32 bits too, does not cost the last frame.
  const double hair = 1e-3 + frames_per_second * std::abs(end) * 1e-7;
  const double last_frame = std::floor((end - begin) * frames_per_second + hair);
  const auto depth = static_cast<double>(camera.chain.size());
  if (last_frame >= kMaxFrames || last_frame * depth >= kMaxTransforms) {
    gltf.fail(fmt::format("has an animation of {:.0f} s, too long to sample", end - begin));
  }
  for (int i = 0; i <= static_cast<int>(last_frame); ++i) {
    const double time = i / frames_per_second;
    glm::dmat4 world_from_camera(1);
    for (auto node = camera.chain.rbegin(); node != camera.chain.rend(); ++node) {
      world_from_camera = world_from_camera * animation.parentFromNode(*node, begin + time);
    }
    appendPose(file, fmt::format("frame {}", i), {time, poseOf(world_from_camera)}, path);
  }
  return path;
}

}  // namespace enfilade
