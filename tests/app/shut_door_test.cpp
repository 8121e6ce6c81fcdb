#include <gtest/gtest.h>

#include "app/film_path.h"
#include "app/walk.h"
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

Camera cameraAt(const House& house, const glm::vec3& eye, const glm::vec3& to) {
  Camera camera = walkingCamera(house, 1.0f, kWidth, kHeight);
  camera.pose.position = eye;
  camera.pose.world_from_camera_rotation =
      glm::quatLookAt(glm::normalize(to - eye), glm::vec3(0, 1, 0));
  return camera;
}

Image paint(FramePainter& painter, Method method, const Camera& camera) {
  painter.paint(method, camera);
  Image picture;
  painter.read(picture);
  return picture;
}

Image paint(House house, Method method, const glm::vec3& eye, const glm::vec3& to) {
  const PortalImages images;
  const auto gl = createOsMesaContext(1);
  FramePainter painter(*gl, house, images, kWidth, kHeight, 1);
  painter.prepare(method);
  return paint(painter, method, cameraAt(house, eye, to));
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

/// A walk past a door that opens and shuts.
class MovingDoor : public ::testing::Test {
 protected:
  Image shown(bool open, Method method) const {
    return paint(houseWithDoor(open), method, kEye, kDoorway);
  }

  const glm::vec3 kEye{1, 1.6f, 2}, kDoorway{4.1f, 1.2f, 2};
  const std::vector<std::uint8_t> open_{1}, shut_{0};
  const PortalImages none_;
  std::unique_ptr<GlContext> gl_ = createOsMesaContext(1);
  House house_ = houseWithDoor(true);
  Camera camera_ = cameraAt(house_, kEye, kDoorway);
};

TEST_F(MovingDoor, IsShownAsInAHouseWhereItStandsSo) {
  FramePainter painter(*gl_, house_, none_, kWidth, kHeight, 1);
  for (const Method method : {Method::kGeometry, Method::kCulling, Method::kRaycast}) {
    painter.setDoors(open_);
    EXPECT_EQ(paint(painter, method, camera_).rgba, shown(true, method).rgba);
    painter.setDoors(shut_);
    EXPECT_EQ(paint(painter, method, camera_).rgba, shown(false, method).rgba);
  }
  painter.setDoors(open_);
  EXPECT_EQ(paint(painter, Method::kCulling, camera_).rgba, shown(true, Method::kCulling).rgba);
}

TEST_F(MovingDoor, ShowsNoImageWhileItIsShut) {
  FramePainter painter(*gl_, house_, none_, kWidth, kHeight, 1, ImageSource::kOnDemand);
  painter.prepare(Method::kTexture);
  const auto portalsSeen = [&] {
    paint(painter, Method::kTexture, camera_);
    return painter.seenPortals();
  };
  ASSERT_EQ(portalsSeen().size(), 1u);
  EXPECT_TRUE(portalsSeen()[0].as_image);
  painter.setDoors(shut_);
  EXPECT_TRUE(portalsSeen().empty());
  EXPECT_EQ(paint(painter, Method::kTexture, camera_).rgba, shown(false, Method::kGeometry).rgba);
}

TEST_F(MovingDoor, MovesWhenThePathSaysSoAndStandsThereInEveryPass) {
  CameraPath path;
  for (int i = 0; i < 6; ++i) path.poses.push_back({0.5 * i, camera_.pose});
  path.doors = {{0.9, "0", false}, {2.0, "?,0", true}};
  const Walk walk(path, camera_, house_, "tour.json");
  FramePainter painter(*gl_, house_, none_, kWidth, kHeight, 1);
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t frame = 0; frame < 6; ++frame) {
      const Image picture = paint(painter, Method::kCulling, walk.stepTo(frame, painter));
      const bool open = frame < 2 || frame >= 4;
      EXPECT_EQ(picture.rgba, shown(open, Method::kCulling).rgba) << "frame " << frame;
    }
  }
  const Image before = paint(painter, Method::kCulling, walk.stepTo(2, painter));
  EXPECT_EQ(before.rgba, shown(false, Method::kCulling).rgba) << "stepping back";
}

TEST_F(MovingDoor, MovesAtItsTimeInAFilmOfAnyFramesASecond) {
  CameraPath path;
  for (int i = 0; i < 4; ++i) path.poses.push_back({1.0 * i, camera_.pose});
  path.doors = {{0.9, "0", false}, {2.0, "0", true}};
  const CameraPath film = filmPath(path, 4, "tour.json");
  const Walk walk(film, camera_, house_, "tour.json");
  FramePainter painter(*gl_, house_, none_, kWidth, kHeight, 1);
  ASSERT_EQ(walk.frames(), 13u);
  for (std::size_t frame = 0; frame < walk.frames(); ++frame) {
    const Image picture = paint(painter, Method::kCulling, walk.stepTo(frame, painter));
    const bool open = frame < 4 || frame >= 8;
    EXPECT_EQ(picture.rgba, shown(open, Method::kCulling).rgba) << "frame " << frame;
  }
}

TEST_F(MovingDoor, MovesInEveryPortalThatItStandsIn) {
  Portal other = house_.graph.portals[0];
  other.name += "#2";
  house_.graph.portals.push_back(other);
  linkCells(house_.graph);
  const std::vector<std::uint8_t> closable = closablePortals(house_);
  moveDoors("0", false, closable, ErrorKind::kUsage, "--shut", house_.graph);
  EXPECT_FALSE(house_.graph.portals[0].active || house_.graph.portals[1].active);
  moveDoors(other.name, true, closable, ErrorKind::kUsage, "--open", house_.graph);
  EXPECT_TRUE(house_.graph.portals[0].active && house_.graph.portals[1].active);
}

TEST_F(MovingDoor, IsNotFoundWithoutALeafOrByAnotherName) {
  const auto complaintOf = [&](const House& house, const std::string& portal) {
    CameraPath path;
    path.poses = {{0, camera_.pose}};
    path.doors = {{0, portal, false}};
    try {
      const Walk walk(path, camera_, house, "tour.json");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaintOf(house_, "*"), "");
  EXPECT_NE(complaintOf(house_, "gate*").find("tour.json: doors[0]: no portal is called 'gate*'"),
            std::string::npos);
  House bare = house_;
  for (ObjectRole& role : bare.object_roles) role = ObjectRole::kFixed;
  EXPECT_NE(complaintOf(bare, "0").find("has no door's leaf"), std::string::npos);
  bare.graph.portals[0].active = false;
  EXPECT_EQ(complaintOf(bare, "0"), "") << "what is shut can be opened";
}

}  // namespace
}  // namespace enfilade
