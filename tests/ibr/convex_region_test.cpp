#include "ibr/convex_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace enfilade {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

/// Which pixels the region holds.
std::vector<bool> filled(const std::vector<glm::vec2>& polygon) {
  std::vector<glm::ivec2> spans(kHeight, glm::ivec2(0));
  const RowRange rows = fillConvexPolygon(polygon, kWidth, kHeight, spans);
  std::vector<bool> pixels(kWidth * kHeight);
  for (int y = rows.top; y < rows.bottom; ++y) {
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    EXPECT_GE(span.x, 0);
    EXPECT_LE(span.x, span.y);
    EXPECT_LE(span.y, kWidth);
    for (int x = span.x; x < span.y; ++x) {
      pixels[static_cast<std::size_t>(y * kWidth + x)] = true;
    }
  }
  return pixels;
}

/// The least signed distance of a pixel's centre from the edges, positive inside.
double insideBy(const std::vector<glm::vec2>& polygon, int x, int y) {
  const glm::dvec2 center(x + 0.5, y + 0.5);
  double least = 1e9;
  double most = -1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 p(polygon[i]);
    const glm::dvec2 q(polygon[(i + 1) % polygon.size()]);
    const glm::dvec2 along = (q - p) / glm::distance(p, q);
    const double distance = along.x * (center.y - p.y) - along.y * (center.x - p.x);
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return std::max(least, -most);  // of either winding
}

std::vector<glm::vec2> randomConvexPolygon(std::mt19937& random) {
  std::uniform_real_distribution<float> x(-15, 55), y(-15, 45), radius(1, 40), angle(0, 6.2831f);
  const glm::vec2 middle(x(random), y(random));
  const glm::vec2 radii(radius(random), radius(random));
  std::vector<float> angles(3 + random() % 6);
  std::generate(angles.begin(), angles.end(), [&] { return angle(random); });
  std::sort(angles.begin(), angles.end());
  std::vector<glm::vec2> polygon;
  for (const float a : angles) {
    polygon.push_back(middle + radii * glm::vec2(std::cos(a), std::sin(a)));
  }
  return polygon;
}

TEST(ConvexRegion, HoldsJustThePixelsWhoseCentresLieInside) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    std::vector<glm::vec2> polygon = randomConvexPolygon(random);
    if (i % 2 == 0) {
      std::reverse(polygon.begin(), polygon.end());
    }
    const std::vector<bool> pixels = filled(polygon);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double inside = insideBy(polygon, x, y);
        if (std::abs(inside) > 1e-4) {
          ASSERT_EQ(pixels[static_cast<std::size_t>(y * kWidth + x)], inside > 0) << x << "," << y;
        }
      }
    }
  }
}

TEST(ConvexRegion, SharesNoPixelBetweenTheTwoHalvesOfAPolygon) {
  // Edges through pixel centres, where both halves could claim them.
  const std::vector<glm::vec2> whole = {{2.5f, 3.5f}, {20.5f, 3.5f}, {20.5f, 21.5f}, {2.5f, 21.5f}};
  const std::vector<bool> all = filled(whole);
  const std::vector<bool> left =
      filled({{2.5f, 3.5f}, {10.5f, 3.5f}, {10.5f, 21.5f}, {2.5f, 21.5f}});
  const std::vector<bool> right =
      filled({{10.5f, 3.5f}, {20.5f, 3.5f}, {20.5f, 21.5f}, {10.5f, 21.5f}});
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_FALSE(left[i] && right[i]);
    EXPECT_EQ(left[i] || right[i], all[i]);
  }
  EXPECT_EQ(std::count(all.begin(), all.end(), true), 18 * 18);
}

TEST(ConvexRegion, IsEmptyForWhatIsNoPolygonOrLiesOutside) {
  const auto count = [](const std::vector<glm::vec2>& polygon) {
    const auto pixels = filled(polygon);
    return std::count(pixels.begin(), pixels.end(), true);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(count({}), 0);
  EXPECT_EQ(count({{1, 1}, {20, 20}}), 0);
  EXPECT_EQ(count({{-50, 2}, {-3, 2}, {-3, 20}}), 0);
  EXPECT_EQ(count({{2, 100}, {30, 100}, {30, 200}}), 0);
  EXPECT_EQ(count({{nan, nan}, {nan, nan}, {nan, nan}}), 0);
  EXPECT_EQ(count({{-1e30f, -1e30f}, {1e30f, -1e30f}, {1e30f, 1e30f}, {-1e30f, 1e30f}}),
            kWidth * kHeight);
  EXPECT_LE(count({{0, 0}, {inf, 0}, {inf, inf}}), kWidth * kHeight);
}

}  // namespace
}  // namespace enfilade
