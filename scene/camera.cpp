#include "scene/camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace enfilade {

glm::mat4 Camera::worldFromCamera() const {
  glm::mat4 m = glm::mat4_cast(pose.world_from_camera_rotation);
  m[3] = glm::vec4(pose.position, 1.0f);
  return m;
}

glm::mat4 Camera::cameraFromWorld() const {
  const glm::mat3 rotation = glm::transpose(glm::mat3_cast(pose.world_from_camera_rotation));
  glm::mat4 m(rotation);
  m[3] = glm::vec4(-(rotation * pose.position), 1.0f);
  return m;
}

glm::mat4 Camera::clipFromCamera() const {
  return glm::perspective(vertical_fov, aspect, near_plane, far_plane);
}

glm::mat4 Camera::clipFromWorld() const { return clipFromCamera() * cameraFromWorld(); }

Pose lookAt(const glm::vec3& eye, const glm::vec3& target) {
  const glm::vec3 back = eye == target ? glm::vec3(0, 0, 1) : glm::normalize(eye - target);
  glm::vec3 right = glm::cross(glm::vec3(0, 1, 0), back);
  if (glm::length(right) < 1e-6f) right = {1, 0, 0};
  right = glm::normalize(right);
  return {eye, glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(back, right), back)))};
}

Pose poseFromAngles(const glm::vec3& eye, float yaw, float pitch) {
  return {eye, glm::normalize(glm::angleAxis(yaw, glm::vec3(0, 1, 0)) *
                              glm::angleAxis(pitch, glm::vec3(1, 0, 0)))};
}

Pose interpolate(const Pose& a, const Pose& b, float t) {
  return {
      glm::mix(a.position, b.position, t),
      glm::normalize(glm::slerp(a.world_from_camera_rotation, b.world_from_camera_rotation, t))};
}

}  // namespace enfilade
