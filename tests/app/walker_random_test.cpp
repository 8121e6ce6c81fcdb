#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>

#include "app/walker.h"
#include "models/samples.h"
#include "preprocess/tour.h"
#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"
#include "tests/app/temporary_folder.h"
#include "tests/preprocess/model_house.h"
#include "tests/preprocess/tour_buildings.h"
#include "tests/preprocess/tour_oracles.h"

namespace enfilade {
namespace {

using testing::bruteCrosses;
using testing::HouseBuilder;

constexpr float kFrame = 1.0f / 60;
constexpr int kTwoMinutes = 7200;
constexpr float kWaist = 0.7f;  // [m] below the eye

/// Presses keys for a while, then others; turns at random, and at once when it gets nowhere.
class RandomWalk {
 public:
  explicit RandomWalk(unsigned seed) : random_(seed) {}

  void step(Walker& walker) {
    if (--left_ <= 0) choose(walker);
    walker.turn(turn_, 0.3f * turn_);
    const glm::vec3 before = walker.eye();
    walker.step(stride_, kFrame);
    idle_ = glm::length(walker.eye() - before) < 2e-3f ? idle_ + 1 : 0;
    if (idle_ > 15) left_ = 0;
  }

 private:
  float uniform(float a, float b) { return std::uniform_real_distribution(a, b)(random_); }

  void choose(Walker& walker) {
    left_ = static_cast<int>(uniform(10, 150));
    turn_ = uniform(-0.03f, 0.03f);
    stride_ = {uniform(-0.3f, 1.2f), uniform(-0.6f, 0.6f), uniform(-1, 1)};
    if (idle_ > 15) walker.turn(uniform(-3, 3), 0);
    idle_ = 0;
  }

  std::mt19937 random_;
  Stride stride_{};
  float turn_ = 0;
  int left_ = 0, idle_ = 0;
};

/// Whether the eye is above a spot with clearance whose floor it could belong to.
bool overASpot(const Walker& walker) {
  const WalkGrid& grid = walker.ground().grid();
  const glm::vec3 eye = walker.eye();
  const glm::ivec2 c = grid.columnAt({eye.x, eye.z});
  if (c.x < 0 || c.y < 0 || c.x >= grid.size.x || c.y >= grid.size.y) return false;
  const auto column = static_cast<std::size_t>(c.x * grid.size.y + c.y);
  for (SpotId s = grid.first[column]; s < grid.first[column + 1]; ++s) {
    const float off = std::abs(grid.floor[s] + walker.gait().eye_height - eye.y);
    if (grid.clearance[s] >= kNarrowestClearance && off <= grid.limits.step_height) return true;
  }
  return false;
}

struct Outcome {
  std::set<CellId> cells;
  int not_free = 0;       // steps whose eye is in no free space
  float fastest_eye = 0;  // [m/s] up or down
};

/// Two minutes; `solid` also looks for triangles between the eyes of two steps, and the waists.
Outcome walkAtRandom(const House& house, Walker& walker, unsigned seed, bool solid) {
  RandomWalk random(seed);
  Outcome outcome;
  for (int i = 0; i < kTwoMinutes; ++i) {
    const glm::vec3 before = walker.eye();
    random.step(walker);
    const glm::vec3 eye = walker.eye();
    const glm::vec2 way(eye.x - before.x, eye.z - before.z);
    const bool fair = glm::length(way) <= 1.01f * walker.gait().speed * kFrame && overASpot(walker);
    const glm::vec3 waist(0, kWaist, 0);
    const bool through = solid && (bruteCrosses(house, before, eye) ||
                                   bruteCrosses(house, before - waist, eye - waist));
    if (!fair || through) {
      ADD_FAILURE() << "seed " << seed << ", step " << i << ": " << eye.x << " " << eye.y << " "
                    << eye.z << (through ? " went through something" : " is no place to stand");
      break;
    }
    const CellLocation at = locate(house.graph, house.grid, eye);
    outcome.not_free += !at.in_free_space;
    outcome.cells.insert(at.cell);
    outcome.fastest_eye = std::max(outcome.fastest_eye, std::abs(eye.y - before.y) / kFrame);
  }
  return outcome;
}

/// Several seeds, each from another cell; what share of the cells they saw together.
void expectFairWalks(const House& house, bool solid, std::size_t least_cells) {
  Walker walker(house);
  std::set<CellId> cells;
  for (unsigned seed = 0; seed < 6; ++seed) {
    walker.setGait({.speed = seed % 2 == 0 ? 1.4f : 4.0f});
    walker.place(walker.eye());
    if (seed > 0) walker.placeInCell(seed % static_cast<CellId>(house.graph.cells.size()));
    if (walker.flying()) walker.setFlying(false);
    const Outcome outcome = walkAtRandom(house, walker, seed, solid);
    EXPECT_LE(outcome.not_free, kTwoMinutes / 100) << "seed " << seed;
    EXPECT_LT(outcome.fastest_eye, 1.5f * walker.gait().speed + 0.5f) << "seed " << seed;
    cells.insert(outcome.cells.begin(), outcome.cells.end());
  }
  EXPECT_GE(cells.size(), least_cells);
}

/// The frames of the house's own tour that a walker does not reach within two seconds from the one
/// before.
int missedFrames(const House& house, const Tour& tour) {
  Walker walker(house);
  walker.place(tour.path.poses.front().pose.position);
  int missed = 0;
  for (const TimedPose& timed : tour.path.poses) {
    const glm::vec3 to = timed.pose.position;
    bool there = false;
    for (int i = 0; i < 120 && !there; ++i) {
      const glm::vec3 way = to - walker.eye();
      const float length = glm::length(glm::vec2(way.x, way.z));
      there = length < 0.1f && std::abs(way.y) < 0.4f;
      walker.look(std::atan2(-way.x, -way.z), 0);
      walker.step({.forward = std::min(1.0f, 5.0f * length)}, kFrame);
    }
    if (there) continue;
    ++missed;
    walker.place(to);
  }
  return missed;
}

House furnished() {
  HouseBuilder b = testing::twoRooms(0.7f);
  b.solid({1, 0, 1}, {1.5f, 0.9f, 2});
  b.solid({3, 0.7f, 3}, {3.5f, 0.75f, 3.6f});
  b.solid({0.5f, 0, 3}, {1.2f, 0.3f, 3.4f});
  b.triangle({6, 0.5f, 3}, {7.1f, 1.3f, 3.3f}, {6.4f, 0.6f, 3.9f});
  return b.build();
}

TEST(WalkerAtRandom, NeverGoesThroughAnythingInFurnishedRooms) {
  expectFairWalks(furnished(), true, 2);
}

TEST(WalkerAtRandom, NeverGoesThroughAnythingInARingOfRooms) {
  expectFairWalks(testing::ringOfRooms().build(), true, 4);
}

TEST(WalkerAtRandom, NeverGoesThroughAnythingOnStairs) {
  expectFairWalks(testing::twoStoreys().build(), true, 2);
}

TEST(WalkerAtRandom, NeverGoesThroughAnythingInAndOutOfACottage) {
  expectFairWalks(testing::cottage().build(), true, 2);
}

TEST(WalkerAtRandom, StaysInARoomWhoseDoorsAreShut) {
  const House house = testing::ringOfRooms().build();
  Walker walker(house);
  walker.setDoors(std::vector<std::uint8_t>(house.graph.portals.size(), 0));
  walker.setGait({.speed = 6});
  for (CellId cell = 1; cell < house.graph.cells.size(); ++cell) {
    ASSERT_TRUE(walker.placeInCell(cell));
    EXPECT_EQ(walkAtRandom(house, walker, cell, true).cells, std::set<CellId>{cell});
  }
}

TEST(WalkerAtRandom, FlyingStaysWithinItsBounds) {
  const House house = testing::cottage().build();
  Walker walker(house);
  walker.setFlying(true);
  walker.setGait({.speed = 20});
  RandomWalk random(7);
  for (int i = 0; i < kTwoMinutes; ++i) {
    const glm::vec3 before = walker.eye();
    random.step(walker);
    ASSERT_TRUE(walker.ground().flightBounds().contains(walker.eye()));
    ASSERT_LE(glm::length(walker.eye() - before), 20.1f * kFrame);
  }
}

TEST(WalkerOnATour, FollowsThoseOfMadeHouses) {
  for (HouseBuilder builder : {testing::ringOfRooms(), testing::twoStoreys(), testing::cottage(),
                               testing::twoRooms(0.5f)}) {
    const House house = builder.build();
    EXPECT_EQ(missedFrames(house, makeTour(house, {.frames = 520})), 0);
  }
}

void expectWalkable(const House& house, std::size_t least_cells) {
  expectFairWalks(house, false, least_cells);
  EXPECT_EQ(missedFrames(house, makeTour(house, {.frames = 520})), 0);
}

TEST(WalkerInModels, WalksTheGallery) {
  const TemporaryFolder folder;
  writeGlb(folder / "gallery.glb", raiseSample("gallery", 50'000));
  expectWalkable(testing::houseOf(readGltf(folder / "gallery.glb"), "", ""), 5);
}

TEST(WalkerInModels, WalksTheSharedBuildings) {
  struct Model {
    const char* name;
    const char* doors;
    const char* windows;
    std::size_t least_cells;
  };
  for (const Model& model : {Model{"duplex", "IfcDoor*", "IfcWindow*", 6},
                             Model{"dream-apartment", "Door*,door*", "", 1}}) {
    const std::string file =
        std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + model.name + ".glb";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the shared models are not here";
    SCOPED_TRACE(model.name);
    expectWalkable(testing::houseOf(readGltf(file), model.doors, model.windows), model.least_cells);
  }
}

}  // namespace
}  // namespace enfilade
