#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace enfilade {

/// Where a camera stands and how it is turned.
struct Pose {
  glm::vec3 position{0};                             ///< world [m]
  glm::quat world_from_camera_rotation{1, 0, 0, 0};  ///< unit; the camera looks down its −Z, +Y up
};

/// All that drawing and culling need of a camera, symmetric or not.
struct View {
  glm::vec3 eye{0};
  glm::mat4 clip_from_world{1};  ///< OpenGL clip space, z in −w…w
};

/// A symmetric perspective camera.
struct Camera {
  Pose pose;
  float vertical_fov = 1.047f;  ///< [rad]
  float aspect = 1.25f;         ///< width / height
  float near_plane = 0.05f;     ///< [m] > 0
  float far_plane = 500.0f;     ///< [m]

  glm::mat4 worldFromCamera() const;
  glm::mat4 cameraFromWorld() const;
  glm::mat4 clipFromCamera() const;  ///< OpenGL clip space, z in −w…w
  glm::mat4 clipFromWorld() const;
  View view() const { return {pose.position, clipFromWorld()}; }
};

/// The pose at `eye` that looks at `target`, +Y up (or its +X along the world's when it looks
/// straight up or down; no rotation when the two are one point).
Pose lookAt(const glm::vec3& eye, const glm::vec3& target);

/// The pose with heading `yaw` (0 looks down −Z, positive turns left) and `pitch` (positive looks
/// up) [rad].
Pose poseFromAngles(const glm::vec3& eye, float yaw, float pitch);

/// Position linear, rotation slerp.
Pose interpolate(const Pose& a, const Pose& b, float t);

}  // namespace enfilade
