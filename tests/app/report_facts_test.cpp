#include "app/report_facts.h"

#include <gtest/gtest.h>

#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

/// From the left room of the two through the doorway at x = 4 into the right one.
CameraPath straightWalk() {
  CameraPath path;
  for (int i = 0; i < 5; ++i) {
    const float x = 1.0f + 1.5f * static_cast<float>(i);
    path.poses.push_back({0.1 * i, lookAt({x, 1.6f, 2.0f}, {x + 1, 1.6f, 2.0f})});
  }
  return path;
}

TEST(ReportPlan, HasAPlaceOnAStoreyForEveryFrame) {
  const House house = twoRoomHouse();
  const CameraPath path = straightWalk();
  const ReportPlan plan = planOf(house, path);
  ASSERT_EQ(plan.storeys.size(), house.graph.storeys.size());
  ASSERT_EQ(plan.steps.size(), path.poses.size());
  for (const ReportPlan::Step& step : plan.steps) {
    EXPECT_LT(step.storey, plan.storeys.size());
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(step.place, glm::vec2(0))));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(step.place, plan.size)));
  }
}

TEST(ReportPlan, DistancesAndHeadingsAreThoseOfTheGroundAtItsScale) {
  const House house = twoRoomHouse();
  CameraPath path = straightWalk();
  path.poses[4].pose = lookAt({7, 1.6f, 2}, {7, 1.6f, 3});  // toward +z, which is down
  const ReportPlan plan = planOf(house, path);
  EXPECT_NEAR(plan.steps[1].place.x - plan.steps[0].place.x, 1.5f * plan.scale, 1e-3);
  EXPECT_NEAR(plan.steps[1].place.y, plan.steps[0].place.y, 1e-3);
  EXPECT_NEAR(plan.steps[0].heading, 0, 1e-3);
  EXPECT_NEAR(plan.steps[4].heading, 90, 1e-3);
}

TEST(ReportPlan, NamesTheCellsAndGrowsToWhereThePathLeads) {
  const House house = twoRoomHouse();
  CameraPath path = straightWalk();
  const ReportPlan near = planOf(house, path);
  for (std::size_t cell = 1; cell < house.graph.cells.size(); ++cell) {
    EXPECT_NE(near.storeys[0].drawing.find(house.graph.cells[cell].name + "</title>"),
              std::string::npos);
  }
  path.poses[0].pose.position.z += 8;  // out of the house
  const ReportPlan far = planOf(house, path);
  EXPECT_GT(far.size.y / far.scale, near.size.y / near.scale + 2);
  path.poses[0].pose.position.z += 1e6f;  // lost
  const ReportPlan lost = planOf(house, path);
  EXPECT_LT(lost.size.y / lost.scale, 4 * near.size.y / near.scale);
}

TEST(ReportPlan, APathOnAnUpperStoreyIsDrawnThere) {
  House house = twoRoomHouse();
  const float floor = house.graph.storeys[0].floor_y;
  house.graph.storeys.push_back({"above", floor + 3});
  CameraPath path = straightWalk();
  path.poses[3].pose.position.y = floor + 3 + house.eye_height;
  path.poses[4].pose.position.y = floor + 1 + house.eye_height;  // on the stairs
  const ReportPlan plan = planOf(house, path);
  EXPECT_EQ(plan.steps[0].storey, 0u);
  EXPECT_EQ(plan.steps[3].storey, 1u);
  EXPECT_EQ(plan.steps[4].storey, 0u);
}

TEST(PathSha256, IsOfThePlacesAndDoorsAndNotOfTheName) {
  CameraPath path = straightWalk(), same = path;
  same.name = "another";
  EXPECT_EQ(pathSha256(path), pathSha256(same));
  same.poses[2].pose.position.x += 0.001f;
  EXPECT_NE(pathSha256(path), pathSha256(same));
  path.doors.push_back({0.1, "door-hall", false});
  EXPECT_NE(pathSha256(path), pathSha256(straightWalk()));
}

TEST(ReportFacts, TellTheHouseAndItsParameters) {
  const House house = twoRoomHouse();
  Report report;
  describeHouse(house, report);
  describePath(house, straightWalk(), report);
  EXPECT_EQ(report.cells, house.graph.cells.size());
  EXPECT_EQ(report.house_parameters, house.info.parameters);
  EXPECT_EQ(report.frames, 5u);
  EXPECT_EQ(report.plan.steps.size(), 5u);
}

}  // namespace
}  // namespace enfilade
