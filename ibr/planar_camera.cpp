#include "ibr/planar_camera.h"

#include <cassert>
#include <cmath>

namespace enfilade {

PlanarCamera planarCamera(const Camera& camera, int width, int height) {
  const glm::dmat3 world_from_camera =
      glm::mat3_cast(glm::normalize(glm::dquat(camera.pose.world_from_camera_rotation)));
  const double near = static_cast<double>(camera.near_plane);
  const double half_height = near * std::tan(0.5 * static_cast<double>(camera.vertical_fov));
  const double half_width = half_height * static_cast<double>(camera.aspect);

  PlanarCamera planar;
  planar.center = glm::dvec3(camera.pose.position);
  planar.world_from_pixel =
      world_from_camera * glm::dmat3(glm::dvec3(2.0 * half_width / width, 0, 0),
                                     glm::dvec3(0, -2.0 * half_height / height, 0),
                                     glm::dvec3(-half_width, half_height, -near));
  planar.width = width;
  planar.height = height;
  return planar;
}

double imagePlaneDistance(const PlanarCamera& camera) {
  const glm::dmat3& p = camera.world_from_pixel;
  return glm::dot(glm::normalize(glm::cross(p[0], p[1])), p[2]);
}

View viewOf(const PlanarCamera& camera, double far_depth) {
  const double near = imagePlaneDistance(camera);
  assert(near > 0 && far_depth > near);
  const double range = far_depth / near;  // the far plane's depth in image plane distances

  // With q = P⁻¹·(X − center) = (u, v, 1)·s, where s is depth in image plane distances, all of clip
  // space is linear in q and 1.
  const glm::dmat3 pixel_from_world = glm::inverse(camera.world_from_pixel);
  const glm::dmat3 clip_from_pixel(glm::dvec3(2.0 / camera.width, 0, 0),
                                   glm::dvec3(0, -2.0 / camera.height, 0), glm::dvec3(-1, 1, 1));
  const glm::dmat3 xyw_from_world = near * (clip_from_pixel * pixel_from_world);
  const glm::dvec3 xyw_offset = -(xyw_from_world * camera.center);
  const double slope = (range + 1.0) / (range - 1.0);
  const double offset = -2.0 * far_depth / (range - 1.0);

  View view;
  view.eye = glm::vec3(camera.center);
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3& xyw = xyw_from_world[column];
    view.clip_from_world[column] = glm::vec4(glm::dvec4(xyw.x, xyw.y, slope * xyw.z, xyw.z));
  }
  view.clip_from_world[3] = glm::vec4(
      glm::dvec4(xyw_offset.x, xyw_offset.y, slope * xyw_offset.z + offset, xyw_offset.z));
  return view;
}

float disparityFromDepth(float depth, double near, double far_depth) noexcept {
  return static_cast<float>(1.0 - static_cast<double>(depth) * (far_depth - near) / far_depth);
}

glm::dvec3 projectPoint(const PlanarCamera& camera, const glm::dvec3& world) {
  const glm::dvec3 q = glm::inverse(camera.world_from_pixel) * (world - camera.center);
  return {q.x / q.z, q.y / q.z, 1.0 / q.z};
}

glm::dvec3 unprojectPoint(const PlanarCamera& camera, const glm::dvec3& pixel_and_disparity) {
  const glm::dvec3 ray =
      camera.world_from_pixel * glm::dvec3(pixel_and_disparity.x, pixel_and_disparity.y, 1.0);
  return camera.center + ray / pixel_and_disparity.z;
}

PlanarCamera withWindow(const PlanarCamera& camera, int x, int y, int width, int height) {
  PlanarCamera window = camera;
  window.world_from_pixel[2] = camera.world_from_pixel * glm::dvec3(x, y, 1);
  window.width = width;
  window.height = height;
  return window;
}

PlanarCamera refined(const PlanarCamera& camera, int factor) {
  PlanarCamera fine = camera;
  fine.world_from_pixel[0] /= factor;
  fine.world_from_pixel[1] /= factor;
  fine.width *= factor;
  fine.height *= factor;
  return fine;
}

}  // namespace enfilade
