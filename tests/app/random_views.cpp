#include "tests/app/random_views.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/frame_painter.h"
#include "portals/cell_grid.h"
#include "preprocess/random_sphere.h"
#include "scene/building.h"

namespace enfilade::testing {

namespace {

bool isSolid(const CellGrid& grid, const glm::ivec3& v) {
  return grid.labelAt(v) == CellGrid::kSolidVoxel;
}

bool hasSolidBeside(const CellGrid& grid, const glm::ivec3& v) {
  for (int i = 0; i < 27; ++i) {
    if (isSolid(grid, v + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1)) return true;
  }
  return false;
}

/// Mostly indoors: there is so much of the exterior.
bool isIndoors(const CellGrid& grid, const glm::ivec3& v) {
  return !isSolid(grid, v) && grid.labelAt(v) != kExterior;
}

bool isAiry(const CellGrid& grid, const glm::ivec3& v) {
  return isIndoors(grid, v) && !hasSolidBeside(grid, v);
}

bool isTight(const CellGrid& grid, const glm::ivec3& v) {
  return isIndoors(grid, v) && hasSolidBeside(grid, v);
}

}  // namespace

const char* nameOf(EyePlace place) {
  constexpr const char* kNames[kEyePlaces] = {
      "free space",      "beside a surface",  "something solid",  "a portal",
      "a portal's edge", "a portal's corner", "a portal's plane", "anywhere"};
  return kNames[static_cast<int>(place)];
}

RandomViews::RandomViews(const House& house, unsigned seed)
    : house_(house),
      bounds_(worldBounds(house.building)),
      far_plane_(walkingCamera(house, 1, 1, 1).far_plane),
      random_(seed) {}

RandomView RandomViews::next(float aspect) {
  return next(static_cast<EyePlace>(random_() % kEyePlaces), aspect);
}

RandomView RandomViews::next(EyePlace place, float aspect) {
  RandomView view{place, {}};
  view.camera.pose = {eyeAt(place), rotation()};
  view.camera.vertical_fov = glm::radians(std::pow(170.0f, uniform(0, 1)));
  view.camera.aspect = aspect;
  view.camera.far_plane = far_plane_;
  return view;
}

glm::vec3 RandomViews::eyeAt(EyePlace place) {
  switch (place) {
    case EyePlace::kFreeSpace:
      return inVoxelThat(isAiry);
    case EyePlace::kBesideSurface:
      return inVoxelThat(isTight);
    case EyePlace::kSolid:
      return inVoxelThat(isSolid);
    case EyePlace::kAnywhere: {
      const float reach = std::pow(8.0f, uniform(-0.5f, 1));
      return bounds_.center() + reach * 0.5f * bounds_.size() * randomInCube(random_);
    }
    default:
      return onPortal(place);
  }
}

glm::vec3 RandomViews::onPortal(EyePlace place) {
  const std::vector<Portal>& portals = house_.graph.portals;
  const std::vector<glm::vec3>& polygon = portals[random_() % portals.size()].polygon;
  const std::size_t i = random_() % polygon.size();
  const glm::vec3& a = polygon[i];
  const glm::vec3& b = polygon[(i + 1) % polygon.size()];
  const glm::vec3& c = polygon[(i + 2) % polygon.size()];
  if (place == EyePlace::kPortalCorner) return a;
  if (place == EyePlace::kPortalEdge) return glm::mix(a, b, uniform(0, 1));
  const float reach = place == EyePlace::kPortal ? 0.0f : 1.0f;
  const float s = uniform(-reach, 1 + reach);
  const float t = place == EyePlace::kPortal ? uniform(0, 1 - s) : uniform(-reach, 1 + reach);
  return b + s * (a - b) + t * (c - b);
}

glm::vec3 RandomViews::inVoxelThat(bool (*fits)(const CellGrid&, const glm::ivec3&)) {
  const CellGrid& grid = house_.grid;
  const glm::vec3 half = 0.5f * grid.voxel() * glm::vec3(grid.size());
  glm::vec3 p(0);
  constexpr int kMostTries = 100'000;  // a house may have no such place
  for (int i = 0; i < kMostTries; ++i) {
    p = grid.origin() + half * (1.0f + randomInCube(random_));
    if (fits(grid, grid.voxelOf(p))) break;
  }
  return p;
}

glm::quat RandomViews::rotation() {
  if (random_() % 2 == 0) {
    return poseFromAngles({}, uniform(-3.2f, 3.2f), uniform(-0.8f, 0.8f))
        .world_from_camera_rotation;
  }
  const float roll = random_() % 4 == 0 ? glm::pi<float>() : uniform(-3.2f, 3.2f);
  return poseFromAngles({}, uniform(-3.2f, 3.2f), uniform(-1.58f, 1.58f))
             .world_from_camera_rotation *
         glm::angleAxis(roll, glm::vec3(0, 0, 1));
}

float RandomViews::uniform(float least, float most) {
  return least + (most - least) * randomUnit(random_);
}

}  // namespace enfilade::testing
