#pragma once

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/glm.hpp>
#include <optional>
#include <random>

#include "scene/camera.h"
#include "visibility/screen_region.h"

namespace enfilade::testing {

inline float uniform(std::mt19937& random, float a, float b) {
  return std::uniform_real_distribution<float>(a, b)(random);
}

/// A view at `eye`, turned at random: upright or not, symmetric or off-axis, now and then mirrored.
inline View randomView(std::mt19937& random, const glm::vec3& eye) {
  Camera camera;
  camera.pose = poseFromAngles(eye, uniform(random, -3.2f, 3.2f), uniform(random, -1.5f, 1.5f));
  camera.vertical_fov = uniform(random, 0.4f, 2.2f);
  camera.aspect = uniform(random, 0.6f, 2.0f);
  View view = camera.view();
  switch (random() % 4) {
    case 0: {
      const float left = uniform(random, -0.08f, 0.04f);
      const float low = uniform(random, -0.08f, 0.04f);
      view.clip_from_world = glm::frustum(left, left + uniform(random, 0.02f, 0.1f), low,
                                          low + uniform(random, 0.02f, 0.1f), 0.05f, 200.0f) *
                             camera.cameraFromWorld();
      break;
    }
    case 1: {  // row 0 on top
      glm::mat4 mirror(1);
      mirror[1][1] = -1;
      view.clip_from_world = mirror * view.clip_from_world;
      break;
    }
    default:
      break;
  }
  return view;
}

/// Where a point stands on the screen; nothing if it is behind the eye or off the screen.
inline std::optional<glm::dvec2> onScreen(const View& view, const glm::dvec3& p) {
  const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(p, 1);
  if (clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w) return std::nullopt;
  return glm::dvec2(clip) / clip.w;
}

/// Distance [NDC] of a point from the nearest edge of a region; negative outside.
inline double depthInside(const ScreenRegion& region, const glm::dvec2& p) {
  double least = region.empty() ? -1e9 : 1e9;
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    const glm::dvec2 a(region.corners[i]);
    const glm::dvec2 edge = glm::dvec2(region.corners[(i + 1) % region.corners.size()]) - a;
    const glm::dvec2 to = p - a;
    least = std::min(least, (edge.x * to.y - edge.y * to.x) / glm::length(edge));
  }
  return least;
}

}  // namespace enfilade::testing
