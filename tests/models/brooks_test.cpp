#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "models/embedded_plans.h"
#include "models/floor_plan.h"
#include "models/plan_layout.h"
#include "models/samples.h"
#include "scene/error.h"

namespace enfilade {
namespace {

FloorPlan brooks() {
  for (const EmbeddedPlan& plan : embeddedPlans()) {
    if (std::string(plan.name) == "brooks") return parseFloorPlan(plan.text, "brooks.json");
  }
  ADD_FAILURE() << "there is no plan of brooks";
  return {};
}

// The figures of the Brooks House: Rafferty, Aliaga, Popescu & Lastra 1998.
constexpr std::size_t kCells = 19, kPortals = 52;
constexpr double kPolygons = 1'744'000;

TEST(Brooks, HasThePapersCellsAndPortals) {
  const FloorPlan plan = brooks();
  const Layout layout = layOut(plan, "brooks.json");
  EXPECT_EQ(layout.rooms.size(), kCells);
  EXPECT_EQ(layout.openings.size(), kPortals);
  const auto windows = std::count_if(
      plan.openings.begin(), plan.openings.end(),
      [](const PlanOpening& opening) { return opening.kind == OpeningKind::kWindow; });
  EXPECT_EQ(windows, 25);
}

TEST(Brooks, WithoutTheCataloguesSaysWhatToInstall) {
  try {
    raiseSample("brooks", 0, "/nowhere");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kMachine);
    EXPECT_NE(std::string(error.what()).find("apt-get install sweethome3d-furniture"),
              std::string::npos);
  }
}

class FurnishedBrooks : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kFurnitureFolder)) {
      GTEST_SKIP() << "sweethome3d-furniture is not installed";
    }
    house_ = raiseSample("brooks");
  }

  /// Whether what stands in a node was set there by the plan's fittings.
  static bool isFitting(const FloorPlan& plan, const std::string& node) {
    const std::string piece = node.substr(0, node.find_last_of('-'));
    return plan.pieces.contains(piece);
  }

  Building house_;
};

TEST_F(FurnishedBrooks, HasThePapersPolygonsAndThanksTheMakers) {
  std::size_t drawn = 0;
  for (const Object& object : house_.objects) {
    if (house_.materialOf(object).name != "marker")
      drawn += house_.meshOf(object).indices.size() / 3;
  }
  EXPECT_NEAR(static_cast<double>(drawn), kPolygons, 0.01 * kPolygons);
  EXPECT_NE(house_.copyright.find("; Bed by "), std::string::npos);
}

TEST_F(FurnishedBrooks, NothingStandsInItsDoorways) {
  const FloorPlan plan = brooks();
  const Layout layout = layOut(plan, "brooks.json");
  for (const LayoutOpening& opening : layout.openings) {
    const PlanOpening& said = plan.openings[opening.plan];
    if (said.kind == OpeningKind::kWindow) continue;
    // Half a metre to either side of the wall, for a walker as wide as the doorway but for its
    // edges.
    Box way;
    const bool along_x = std::any_of(plan.walls.begin(), plan.walls.end(), [&](const PlanWall& w) {
      return w.from.y == w.to.y && w.from.y == said.at.y &&
             std::min(w.from.x, w.to.x) < said.at.x && std::max(w.from.x, w.to.x) > said.at.x;
    });
    const double across = 0.5 * said.width - 0.1, deep = 0.5;
    const glm::dvec2 half = along_x ? glm::dvec2(across, deep) : glm::dvec2(deep, across);
    way.extend(glm::vec3(said.at.x - half.x, 0.2, said.at.y - half.y));
    way.extend(glm::vec3(said.at.x + half.x, 1.7, said.at.y + half.y));
    for (const Object& object : house_.objects) {
      const std::string& name = house_.nodes[object.node].name;
      if (!isFitting(plan, name)) continue;
      const Box box = worldBounds(house_, object);
      EXPECT_FALSE(way.overlaps(box))
          << name << " stands in the way at " << said.at.x << ", " << said.at.y;
    }
  }
}

}  // namespace
}  // namespace enfilade
