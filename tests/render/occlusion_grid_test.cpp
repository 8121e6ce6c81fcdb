#include "render/occlusion_grid.h"

#include <gtest/gtest.h>

#include <random>

namespace enfilade {
namespace {

constexpr int kWidth = 100;  // no multiple of a square's side
constexpr int kHeight = 64;
constexpr OcclusionGrid::Limits kExact = {0, 1e9, 1, 0};

OcclusionGrid::Corners corners(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                               const glm::dvec3& w) {
  return {glm::dvec3(a * w.x, w.x), glm::dvec3(b * w.y, w.y), glm::dvec3(c * w.z, w.z)};
}

/// The depth 1 / w at which a ray through a pixel meets a triangle; 0 if it doesn't.  By solving
/// for the point's weights, in no way as the grid does.
double depthAt(const OcclusionGrid::Corners& c, const glm::dvec2& pixel) {
  const glm::dmat3 m(c[0], c[1], c[2]);
  if (std::abs(glm::determinant(m)) < 1e-12) return 0;
  const glm::dvec3 weights = glm::inverse(m) * glm::dvec3(pixel, 1);
  if (glm::any(glm::lessThan(weights, glm::dvec3(0)))) return 0;
  return weights.x + weights.y + weights.z;
}

TEST(OcclusionGrid, AnEmptyOneHidesNothing) {
  OcclusionGrid grid;
  grid.start(kWidth, kHeight);
  EXPECT_FALSE(grid.hides(0, 0, 0, 0, 0.0f));
}

TEST(OcclusionGrid, HidesWhatIsBehindAndNothingElse) {
  OcclusionGrid grid;
  grid.start(kWidth, kHeight);
  grid.add(corners({-500, -500}, {900, -500}, {0, 900}, {4, 4, 4}), kExact, 0, kHeight - 1);
  EXPECT_TRUE(grid.hides(0, 0, kWidth - 1, kHeight - 1, 0.24f));
  EXPECT_FALSE(grid.hides(50, 30, 51, 31, 0.26f));
  EXPECT_FALSE(grid.hides(50, 30, 51, 31, std::numeric_limits<float>::infinity()));
}

TEST(OcclusionGrid, ATriangleHidesNoMoreThanItCovers) {
  OcclusionGrid grid;
  grid.start(kWidth, kHeight);
  grid.add(corners({0, 0}, {48, 0}, {0, 48}, {1, 1, 1}), kExact, 0, kHeight - 1);
  EXPECT_TRUE(grid.hides(1, 1, 14, 14, 0.5f));
  EXPECT_FALSE(grid.hides(40, 40, 41, 41, 0.5f));
  EXPECT_FALSE(grid.hides(1, 1, 60, 1, 0.5f));
}

/// In every corner of every square that hides something the triangle is met, and nearer than that.
void expectCovered(const OcclusionGrid& grid, const OcclusionGrid::Corners& c, int& hiding) {
  const int side = OcclusionGrid::kSide;
  for (int y = 0; y < kHeight; y += side) {
    for (int x = 0; x < kWidth; x += side) {
      float depth = 0;  // the nearest that is hidden, by halving
      for (float step = 16; step > 1e-4f; step /= 2) {
        if (grid.hides(x, y, std::min(x + side, kWidth) - 1, std::min(y + side, kHeight) - 1,
                       depth + step)) {
          depth += step;
        }
      }
      if (depth == 0) continue;
      ++hiding;
      for (const glm::dvec2 corner :
           {glm::dvec2(0, 0), glm::dvec2(side, 0), glm::dvec2(0, side), glm::dvec2(side, side)}) {
        EXPECT_GE(depthAt(c, glm::dvec2(x, y) + corner), depth * (1 - 1e-6)) << x << ' ' << y;
      }
    }
  }
}

TEST(OcclusionGrid, HidesOnlyWhatItsTriangleIsBeforeEvenIfThatReachesBehindTheEye) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-150, 250);
  std::uniform_real_distribution<double> depth(-1, 4);
  int hiding = 0;
  int behind = 0;
  for (int i = 0; i < 3000; ++i) {
    OcclusionGrid::Corners c =
        corners({place(random), place(random)}, {place(random), place(random)},
                {place(random), place(random)}, {depth(random), depth(random), depth(random)});
    OcclusionGrid grid;
    grid.start(kWidth, kHeight);
    grid.add(c, kExact, 0, kHeight - 1);
    const int before = hiding;
    expectCovered(grid, c, hiding);
    const double least = std::min({c[0].z, c[1].z, c[2].z});
    behind += least < 0 && hiding > before;
  }
  EXPECT_GT(hiding, 5000);  // or the comparison would say little
  EXPECT_GT(behind, 100);
}

TEST(OcclusionGrid, LimitsTakeOffWhatMayNotBeDrawn) {
  const auto wall = corners({-500, -500}, {900, -500}, {0, 900}, {4, 4, 4});
  const auto hidesWith = [&](const OcclusionGrid::Limits& limits, float nearest) {
    OcclusionGrid grid;
    grid.start(kWidth, kHeight);
    grid.add(wall, limits, 0, kHeight - 1);
    return grid.hides(50, 30, 51, 31, nearest);
  };
  EXPECT_TRUE(hidesWith(kExact, 0.2f));
  EXPECT_FALSE(hidesWith({.nearest = 0.2}, 0.2f));
  EXPECT_FALSE(hidesWith({.nearest = 9, .factor = 0.7}, 0.2f));
  EXPECT_FALSE(hidesWith({.nearest = 9, .less = 0.06}, 0.2f));
  EXPECT_FALSE(hidesWith({.slack = 1000, .nearest = 9}, 0.2f));
}

}  // namespace
}  // namespace enfilade
