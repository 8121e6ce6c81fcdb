#include <gtest/gtest.h>

#include "app/frame_painter.h"
#include "portals/open_doors.h"
#include "preprocess/tour.h"
#include "tests/preprocess/tour_houses.h"

namespace enfilade {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 80;

/// Two rooms with a door between, whose leaf fills the doorway; and another leaf in a wardrobe.
House houseWithDoor(bool active) {
  testing::HouseBuilder builder = testing::twoRooms(1.0f);
  builder.solid({7.0f, 0, 3.0f}, {7.8f, 1.2f, 3.6f});
  builder.solid({4.08f, 0, 1.5f}, {4.14f, 2.1f, 2.5f}, ObjectRole::kDoor);
  builder.solid({1.0f, 0, 0.1f}, {1.9f, 2.0f, 0.15f}, ObjectRole::kDoor);
  House house = builder.build();
  std::vector<CellId> all;
  for (CellId cell = 0; cell < house.graph.cells.size(); ++cell) all.push_back(cell);
  house.object_cells.assign(house.building.objects.size(), all);
  house.object_cells[house.object_cells.size() - 2] = {2};  // beyond the portal for who looks
  for (Portal& portal : house.graph.portals) portal.active = active;
  Building& building = house.building;  // all else is white
  building.meshes[building.objects[building.objects.size() - 2].mesh].material =
      static_cast<std::uint32_t>(building.materials.size());
  building.materials.push_back({.name = "oak", .base_color = {0.3f, 0.1f, 0.0f, 1}});
  return house;
}

Image paint(const House& house, Method method, const glm::vec3& eye, const glm::vec3& to) {
  const PortalImages images;
  const auto gl = createOsMesaContext(1);
  FramePainter painter(*gl, house, images, kWidth, kHeight, 1);
  Camera camera = walkingCamera(house, 1.0f, kWidth, kHeight);
  camera.pose.position = eye;
  camera.pose.world_from_camera_rotation =
      glm::quatLookAt(glm::normalize(to - eye), glm::vec3(0, 1, 0));
  painter.prepare(method);
  painter.paint(method, camera);
  Image picture;
  painter.read(picture);
  return picture;
}

TEST(ShutDoor, IsTheOneInTheShutPortal) {
  const auto shut = openDoors(houseWithDoor(false));
  const auto open = openDoors(houseWithDoor(true));
  ASSERT_GE(shut.size(), 2u);
  EXPECT_EQ(open[open.size() - 2], 1);
  EXPECT_EQ(shut[shut.size() - 2], 0);
  EXPECT_EQ(open.back(), 1);
  EXPECT_EQ(shut.back(), 1);
  for (std::size_t i = 0; i + 2 < shut.size(); ++i) EXPECT_EQ(shut[i], 0);
}

TEST(ShutDoor, IsDrawnAndCulls) {
  const glm::vec3 doorway(4.1f, 1.2f, 2);
  for (const glm::vec3& eye : {glm::vec3(1, 1.6f, 2), glm::vec3(2.5f, 1.4f, 0.8f)}) {
    const House house = houseWithDoor(false);
    const Image truth = paint(house, Method::kGeometry, eye, doorway);
    EXPECT_EQ(paint(house, Method::kCulling, eye, doorway).rgba, truth.rgba);
    EXPECT_NE(paint(houseWithDoor(true), Method::kGeometry, eye, doorway).rgba, truth.rgba);
  }
}

TEST(ShutDoor, IsMetByRays) {
  const glm::vec3 eye(1, 1.6f, 2), doorway(4.1f, 1.2f, 2);
  const auto middle = [&](bool active) {
    const Image picture = paint(houseWithDoor(active), Method::kRaycast, eye, doorway);
    return picture.rgba[4 * (kHeight / 2 * kWidth + kWidth / 2)];
  };
  const Image truth = paint(houseWithDoor(false), Method::kGeometry, eye, doorway);
  EXPECT_NEAR(middle(false), truth.rgba[4 * (kHeight / 2 * kWidth + kWidth / 2)], 2);
  EXPECT_NE(middle(false), middle(true));
}

TEST(ShutDoor, IsAnObstacleToATour) {
  EXPECT_EQ(makeTour(houseWithDoor(true), {.frames = 20}).visited.size(), 2u);
  EXPECT_EQ(makeTour(houseWithDoor(false), {.frames = 20}).visited.size(), 1u);
}

}  // namespace
}  // namespace enfilade
