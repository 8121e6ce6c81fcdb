// The like of the houses that the paper measured: their cells, portals, polygons; free doorways.
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

/// The figures of a house in Rafferty, Aliaga, Popescu & Lastra 1998.
struct PaperHouse {
  const char* name;
  std::size_t storeys, cells, portals;
  double polygons;
};

void PrintTo(const PaperHouse& house, std::ostream* out) { *out << house.name; }

FloorPlan planOf(const std::string& name) {
  for (const EmbeddedPlan& plan : embeddedPlans()) {
    if (plan.name == name) return parseFloorPlan(plan.text, name + ".json");
  }
  ADD_FAILURE() << "there is no plan of " << name;
  return {};
}

class PaperHouses : public testing::TestWithParam<PaperHouse> {};

TEST_P(PaperHouses, HaveThePapersCellsAndPortals) {
  const FloorPlan plan = planOf(GetParam().name);
  const std::vector<Layout> layouts = layOut(plan, GetParam().name);
  EXPECT_EQ(layouts.size(), GetParam().storeys);
  std::size_t rooms = 0, portals = 0;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    rooms += layouts[i].rooms.size();
    portals += layouts[i].openings.size() + plan.storeys[i].wells.size();
  }
  EXPECT_EQ(rooms, GetParam().cells);
  EXPECT_EQ(portals, GetParam().portals);
}

TEST_P(PaperHouses, WithoutTheCataloguesSayWhatToInstall) {
  try {
    raiseSample(GetParam().name, 0, "/nowhere");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kMachine);
    EXPECT_NE(std::string(error.what()).find("apt-get install sweethome3d-furniture"),
              std::string::npos);
  }
}

class FurnishedHouses : public PaperHouses {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kFurnitureFolder)) {
      GTEST_SKIP() << "sweethome3d-furniture is not installed";
    }
    house_ = raiseSample(GetParam().name);
  }

  Building house_;
};

TEST_P(FurnishedHouses, HaveThePapersPolygonsAndThankTheMakers) {
  std::size_t drawn = 0;
  for (const Object& object : house_.objects) {
    if (house_.materialOf(object).name != "marker")
      drawn += house_.meshOf(object).indices.size() / 3;
  }
  const double polygons = GetParam().polygons;
  EXPECT_NEAR(static_cast<double>(drawn), polygons, 0.01 * polygons);
  EXPECT_NE(house_.copyright.find("; Chair by "), std::string::npos) << house_.copyright;
}

TEST_P(FurnishedHouses, HaveThemToBeLitTooAndTheirLampsShine) {
  const Building house = raiseSample(GetParam().name, 0, kFurnitureFolder, true);
  std::size_t drawn = 0;
  for (const Object& object : house.objects) {
    if (house.materialOf(object).name == "marker") continue;
    drawn += house.meshOf(object).indices.size() / 3;
    EXPECT_FALSE(house.materialOf(object).unlit);
  }
  const double polygons = GetParam().polygons;
  EXPECT_NEAR(static_cast<double>(drawn), polygons, 0.01 * polygons);
  ASSERT_GE(house.lights.size(), GetParam().cells);
  for (const Light& light : house.lights) {
    const float height = house.nodes[light.node].world_from_node[3].y;
    EXPECT_TRUE(height > 0.2f && height < 6.2f) << light.name;
  }
  EXPECT_TRUE(wantsBakedLight(GetParam().name));
}

TEST(Gallery, IsNotLit) { EXPECT_FALSE(wantsBakedLight("gallery")); }

/// Half a metre to either side of the wall, for a walker as wide as the doorway but for its edges.
Box wayThrough(const PlanStorey& storey, const PlanOpening& opening) {
  const bool along_x =
      std::any_of(storey.walls.begin(), storey.walls.end(), [&](const PlanWall& w) {
        return w.from.y == w.to.y && w.from.y == opening.at.y &&
               std::min(w.from.x, w.to.x) < opening.at.x &&
               std::max(w.from.x, w.to.x) > opening.at.x;
      });
  const double across = 0.5 * opening.width - 0.1, deep = 0.5, floor = storey.floor;
  const glm::dvec2 half = along_x ? glm::dvec2(across, deep) : glm::dvec2(deep, across);
  Box way;
  way.extend(glm::vec3(opening.at.x - half.x, floor + 0.2, opening.at.y - half.y));
  way.extend(glm::vec3(opening.at.x + half.x, floor + 1.7, opening.at.y + half.y));
  return way;
}

TEST_P(FurnishedHouses, HaveNothingInTheirDoorways) {
  const FloorPlan plan = planOf(GetParam().name);
  for (const PlanStorey& storey : plan.storeys) {
    for (const PlanOpening& opening : storey.openings) {
      if (opening.kind == OpeningKind::kWindow) continue;
      const Box way = wayThrough(storey, opening);
      for (const Object& object : house_.objects) {
        const std::string& node = house_.nodes[object.node].name;
        if (!plan.pieces.contains(node.substr(0, node.find_last_of('-')))) continue;
        EXPECT_FALSE(way.overlaps(worldBounds(house_, object)))
            << node << " stands in the way at " << opening.at.x << ", " << opening.at.y;
      }
    }
  }
}

const PaperHouse kHouses[] = {{"brooks", 1, 19, 52, 1'744'000}, {"haunted", 2, 7, 12, 214'000}};

std::string nameOf(const testing::TestParamInfo<PaperHouse>& house) { return house.param.name; }

INSTANTIATE_TEST_SUITE_P(OfThePaper, PaperHouses, testing::ValuesIn(kHouses), nameOf);
INSTANTIATE_TEST_SUITE_P(OfThePaper, FurnishedHouses, testing::ValuesIn(kHouses), nameOf);

}  // namespace
}  // namespace enfilade
