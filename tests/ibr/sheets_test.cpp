#include "ibr/sheets.h"

#include <gtest/gtest.h>

#include <map>

#include "analytic_scene.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

using testing::AnalyticScene;
using testing::Random;

/// Boxes of all sizes behind the plane z = 0.
AnalyticScene randomScene(Random& random) {
  AnalyticScene scene;
  scene.boxes.push_back({{-6, -2, -6}, {6, 5, -0.001}, {0.5, 0.5, 0.5}, 0.0, true});
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 size(random(0.05, 0.5), random(0.05, 0.8), random(0.05, 0.5));
    const glm::dvec3 at(random(-2.0, 2.0), random(0.0, 2.2), random(-4.0, -0.6));
    scene.boxes.push_back({at, at + size, {0.5, 0.5, 0.5}, 0.0, false});
  }
  return scene;
}

/// What the reference camera and four to its sides see, in layers.
Ldi layersOf(const AnalyticScene& scene) {
  const PlanarCamera central = testing::referenceCamera(128);
  LdiBuilder builder(central, {0.5f, 8.0f});
  for (const double x : {0.0, -0.7, 0.7, -1.3, 1.3}) {
    PlanarCamera camera = central;
    camera.center.x += x;
    camera.world_from_pixel[2].x -= x;
    builder.insert(resolveCapture(testing::castImage(scene, camera), 1, 0.001f));
  }
  return builder.finish();
}

/// The disparity at every pixel of `desired` when each sample of `ldi` overwrites the pixel into
/// which its point falls, in the order in which `visit` gives the tiles.
template <class Visit>
std::vector<double> paint(const Ldi& ldi, const PlanarCamera& desired, bool nearest_wins,
                          Visit&& visit) {
  std::vector<double> picture(static_cast<std::size_t>(desired.width * desired.height));
  const WarpTransform warp = warpTransform(ldi.camera, desired);
  visit([&](const LdiTile& tile) {
    for (const LdiSample& s : std::span(ldi.samples).subspan(tile.first, tile.count)) {
      const glm::dvec3 place = testing::storedPlace(tile, s);
      const glm::dvec3 h = warp.homogeneous(place.x, place.y, place.z);
      const double x = std::floor(h.x / h.z);
      const double y = std::floor(h.y / h.z);
      if (h.z > 0 && x >= 0 && y >= 0 && x < desired.width && y < desired.height) {
        double& pixel =
            picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(desired.width) +
                    static_cast<std::size_t>(x)];
        const double disparity = place.z / h.z;
        pixel = nearest_wins ? std::max(pixel, disparity) : disparity;
      }
    }
  });
  return picture;
}

/// Pixels that show a surface more than 5 % farther than the nearest one there.
int wrongPixels(const std::vector<double>& painted, const std::vector<double>& nearest) {
  int wrong = 0;
  for (std::size_t i = 0; i < painted.size(); ++i) {
    wrong += painted[i] * 1.05 < nearest[i];
  }
  return wrong;
}

struct Score {
  int views = 0, pixels = 0, in_order = 0, against_order = 0, in_memory_order = 0;
};

TEST(SheetOrder, AgreesWithAZBufferForFourTwoAndOneSheetsInFrontAndBehind) {
  Random random(11);
  std::map<std::pair<bool, int>, Score> scores;  // by: in front, number of sheets
  for (int round = 0; round < 3; ++round) {
    const Ldi ldi = layersOf(randomScene(random));
    for (int view = 0; view < 60; ++view) {
      const bool before = view % 2 == 0;
      const double z = before ? random(0.2, 1.4) : random(1.6, 5.0);
      const double spread = view % 3 == 0 ? 3.0 : before ? 0.6 : 0.3 * z;
      const glm::dvec3 eye(random(-spread, spread), 1.6 + 0.6 * random(-spread, spread), z);
      const PlanarCamera desired =
          testing::desiredCamera(eye, {random(-0.4, 0.4), random(0.6, 1.6), -1.0}, 320, 256);
      SheetOrder order = sheetOrder(ldi.camera, eye);
      ASSERT_EQ(order.toward, before);
      Score& score = scores[{before, sheetCount(order, ldi.camera)}];

      const auto in_sheets = [&](auto&& draw) { visitInSheets(ldi, order, draw); };
      const auto in_memory = [&](auto&& draw) {
        for (const LdiTile& tile : ldi.tiles) {
          draw(tile);
        }
      };
      const std::vector<double> nearest = paint(ldi, desired, true, in_memory);
      score.views += 1;
      score.pixels += static_cast<int>(
          std::count_if(nearest.begin(), nearest.end(), [](double d) { return d > 0; }));
      score.in_order += wrongPixels(paint(ldi, desired, false, in_sheets), nearest);
      score.in_memory_order += wrongPixels(paint(ldi, desired, false, in_memory), nearest);
      order.toward = !order.toward;
      score.against_order += wrongPixels(paint(ldi, desired, false, in_sheets), nearest);
    }
  }
  for (const bool before : {true, false}) {
    for (const int sheets : {4, 2, 1}) {
      const Score& s = scores[{before, sheets}];
      SCOPED_TRACE(std::to_string(sheets) + (before ? " sheets in front" : " sheets behind"));
      EXPECT_GE(s.views, 3);
      EXPECT_LE(s.in_order, s.pixels / 2000);             // 0.05 %
      EXPECT_GE(s.against_order, 20 * s.in_order + 100);  // so the direction matters
    }
  }
}

TEST(SheetOrder, SplitsWhereTheEyeIsSeen) {
  PlanarCamera reference = testing::referenceCamera(128);  // 64 × 128 pixels: 4 × 8 tiles
  const auto order = [&](const glm::dvec3& pixel) {
    return sheetOrder(reference, unprojectPoint(reference, pixel));
  };
  EXPECT_EQ(order({20, 100, 1.5}).column, 1);
  EXPECT_EQ(order({20, 100, 1.5}).row, 6);
  EXPECT_TRUE(order({20, 100, 1.5}).toward);
  EXPECT_FALSE(order({20, 100, -1.5}).toward);
  EXPECT_EQ(sheetCount(order({20, 100, 1.5}), reference), 4);
  EXPECT_EQ(sheetCount(order({-20, 100, 1.5}), reference), 2);
  EXPECT_EQ(sheetCount(order({20, 1000, -1.5}), reference), 2);
  EXPECT_EQ(sheetCount(order({-20, 1000, 1.5}), reference), 1);
  EXPECT_EQ(order({-20, 1000, 1.5}).column, -1);
  EXPECT_EQ(order({-20, 1000, 1.5}).row, 8);
  // Beside the reference's own centre: infinitely far to the upper right.
  const SheetOrder beside = sheetOrder(reference, reference.center + glm::dvec3(1, 1, 0));
  EXPECT_EQ(sheetCount(beside, reference), 1);
  EXPECT_EQ(beside.column, beside.toward ? 4 : -1);
  EXPECT_EQ(beside.row, beside.toward ? -1 : 8);
}

TEST(SheetOrder, VisitsEveryTileOnce) {
  Random random(12);
  const Ldi ldi = testing::randomLdi(random, 2000);
  for (int i = 0; i < 50; ++i) {
    SheetOrder order;
    order.column = random(-1, 12);
    order.row = random(-1, 12);
    order.toward = i % 2 == 0;
    std::vector<int> visits(ldi.tiles.size());
    visitInSheets(ldi, order, [&](const LdiTile& tile) {
      ++visits[static_cast<std::size_t>(&tile - ldi.tiles.data())];
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<int>(visits.size()));
  }
}

TEST(SheetOrder, ComesTowardTheEyesPictureInEveryRowAndColumnOrGoesAway) {
  Random random(13);
  const Ldi ldi = testing::randomLdi(random, 4000);
  for (int i = 0; i < 50; ++i) {
    SheetOrder order;
    order.column = random(-1, 12);
    order.row = random(-1, 12);
    order.toward = i % 2 == 0;
    // Of two tiles on one side of the picture, the one farther in both directions comes first.
    std::vector<glm::ivec2> seen;
    visitInSheets(ldi, order, [&](const LdiTile& tile) {
      const glm::ivec2 at(tile.x - order.column, tile.y - order.row);
      for (const glm::ivec2& earlier : seen) {
        const bool one_side = earlier.x * at.x >= 0 && earlier.y * at.y >= 0;
        const glm::ivec2 step = glm::abs(at) - glm::abs(earlier);
        const bool farther = step.x >= 0 && step.y >= 0;
        const bool nearer = step.x <= 0 && step.y <= 0;
        EXPECT_FALSE(one_side && (order.toward ? farther : nearer) && at != earlier);
      }
      seen.push_back(at);
    });
  }
}

TEST(SheetOrder, VisitsNothingOfAnEmptyImage) {
  visitInSheets(Ldi{}, SheetOrder{}, [](const LdiTile&) { FAIL(); });
}

}  // namespace
}  // namespace enfilade
