#include "visibility/screen_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "portals/cell_graph.h"
#include "test_views.h"

namespace enfilade {
namespace {

using namespace enfilade::testing;

glm::vec3 randomVector(std::mt19937& random, float size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

/// A convex polygon in a random plane: corners on an ellipse.
std::vector<glm::vec3> randomPolygon(std::mt19937& random, const glm::vec3& center) {
  const glm::vec3 a = randomVector(random, 2);
  const glm::vec3 b = randomVector(random, 2);
  const int count = 3 + static_cast<int>(random() % 5);
  std::vector<float> angles;
  for (int i = 0; i < count; ++i) angles.push_back(uniform(random, 0, 6.28f));
  std::sort(angles.begin(), angles.end());
  std::vector<glm::vec3> polygon;
  for (const float angle : angles) {
    polygon.push_back(center + std::cos(angle) * a + std::sin(angle) * b);
  }
  return polygon;
}

/// Whether the ray from `eye` meets the polygon, and how surely: the least of the sine between the
/// ray and the planes through the eye and an edge; negative outside.
double hitMargin(const std::vector<glm::vec3>& polygon, const glm::dvec3& eye,
                 const glm::dvec3& unit_direction) {
  double least = 1;
  double most = -1;
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(polygon[i]) - eye;
    const glm::dvec3 b = glm::dvec3(polygon[(i + 1) % polygon.size()]) - eye;
    const double sine = glm::dot(glm::normalize(glm::cross(a, b)), unit_direction);
    least = std::min(least, sine);
    most = std::max(most, sine);
    normal += glm::cross(a, b);
  }
  // Ahead, not behind.
  const double ahead = glm::dot(normal, glm::dvec3(polygon[0]) - eye);
  const double towards = glm::dot(normal, unit_direction);
  if (ahead * towards <= 0) return -1;
  return towards > 0 ? least : -most;
}

glm::dvec3 directionOf(const View& view, const glm::dvec2& at) {
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
  const glm::dvec4 far = world_from_clip * glm::dvec4(at, 1, 1);
  return glm::normalize(glm::dvec3(far) / far.w - glm::dvec3(view.eye));
}

TEST(ScreenRegion, WholeScreenHoldsJustTheScreen) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const View view = randomView(random, randomVector(random, 10));
    const ScreenRegion screen = wholeScreen(view);
    for (int i = 0; i < 50; ++i) {
      const glm::vec3 p = view.eye + randomVector(random, 10);
      const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(p, 1);
      const double inside = std::min(clip.w - std::abs(clip.x), clip.w - std::abs(clip.y));
      if (std::abs(inside) < 1e-3) continue;
      EXPECT_EQ(mayBeSeen(screen, Box{p, p}), inside > 0);
    }
  }
}

TEST(ScreenRegion, ClippingAgreesWithRaysThroughThePolygon) {
  std::mt19937 random(2);
  int inside = 0;
  int outside = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const glm::vec3 eye = randomVector(random, 3);
    const View view = randomView(random, eye);
    // In front of the eye, about it, behind it.
    const auto polygon = randomPolygon(random, eye + randomVector(random, 3));
    const ScreenRegion region = clipRegion(view, wholeScreen(view), polygon);
    for (int i = 0; i < 40; ++i) {
      const glm::dvec2 at(uniform(random, -1, 1), uniform(random, -1, 1));
      const double hit = hitMargin(polygon, glm::dvec3(eye), directionOf(view, at));
      if (hit > 0) {
        ++inside;
        EXPECT_GE(depthInside(region, at), 0) << "lost by " << hit;
      } else if (depthInside(region, at) > 0) {
        // Only for the slack: the polygon is near.
        EXPECT_GT(hit, -1) << "sees the back of its head";
        EXPECT_GT(hit, -0.02);
      } else {
        ++outside;
      }
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

TEST(ScreenRegion, ClippingTwiceIsTheIntersection) {
  std::mt19937 random(3);
  int inside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const glm::vec3 eye = randomVector(random, 3);
    const View view = randomView(random, eye);
    const auto near = randomPolygon(random, eye + randomVector(random, 2));
    // Behind the near one, more or less.
    const glm::vec3 middle = 0.5f * (near[0] + near[near.size() / 2]);
    const auto far = randomPolygon(random, eye + 1.5f * (middle - eye));
    const ScreenRegion region = clipRegion(view, clipRegion(view, wholeScreen(view), near), far);
    for (int i = 0; i < 40; ++i) {
      const glm::dvec2 at(uniform(random, -1, 1), uniform(random, -1, 1));
      const glm::dvec3 direction = directionOf(view, at);
      if (std::min(hitMargin(near, glm::dvec3(eye), direction),
                   hitMargin(far, glm::dvec3(eye), direction)) <= 0) {
        continue;
      }
      ++inside;
      EXPECT_GE(depthInside(region, at), 0);
      const glm::vec3 p = eye + glm::vec3(direction * double(uniform(random, 0.1f, 100)));
      EXPECT_TRUE(mayBeSeen(region, Box{p, p}));
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(ScreenRegion, PlanesPassThroughTheEyeAndTheEdges) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 500; ++trial) {
    const glm::vec3 eye = randomVector(random, 20);
    const View view = randomView(random, eye);
    const ScreenRegion region =
        clipRegion(view, wholeScreen(view), randomPolygon(random, eye + randomVector(random, 3)));
    ASSERT_EQ(region.planes.size(), region.corners.size());
    for (std::size_t i = 0; i < region.corners.size(); ++i) {
      EXPECT_NEAR(region.planes[i].signedDistance(eye), 0, 1e-5f);
      const glm::vec3 along(directionOf(view, region.corners[i]));
      EXPECT_NEAR(glm::dot(region.planes[i].normal, along), 0, 1e-4f);
      // The whole region lies on its inner side.
      for (const glm::vec2& corner : region.corners) {
        EXPECT_GT(glm::dot(region.planes[i].normal, glm::vec3(directionOf(view, corner))), -1e-4f);
      }
    }
  }
}

TEST(ScreenRegion, APolygonSeenEdgeOnLeavesAThinRegionAlongItAlone) {
  const View view = Camera{.pose = lookAt({0, 0, 0}, {0, 0, -1})}.view();
  const std::vector<glm::vec3> polygon = {{0, -1, -2}, {0, 1, -2}, {0, 1, -4}, {0, -1, -4}};
  const ScreenRegion region = clipRegion(view, wholeScreen(view), polygon);
  EXPECT_FALSE(mayBeSeen(region, {{-1, -1, -2}, {-0.1f, 1, -1.9f}}));
  EXPECT_TRUE(mayBeSeen(region, {{0, 0, -3}, {0, 0.5f, -3}}));
  // Not along the whole plane: the polygon ends 1 above, seen 2 away.
  EXPECT_FALSE(mayBeSeen(region, {{-0.01f, 1.2f, -2}, {0.01f, 1.3f, -2}}));
}

TEST(ScreenRegion, AnEyeOnThePolygonSeesAllThroughIt) {
  const std::vector<glm::vec3> polygon = {{0, -1, -2}, {0, 1, -2}, {0, 1, 2}, {0, -1, 2}};
  for (const glm::vec3 eye : {glm::vec3(0), glm::vec3(0, 1, 0.5f), glm::vec3(0, 1, 2)}) {
    const View view = Camera{.pose = lookAt(eye, eye + glm::vec3(1, 0, 0.3f))}.view();
    EXPECT_TRUE(contains(clipRegion(view, wholeScreen(view), polygon), wholeScreen(view)));
  }
}

TEST(ScreenRegion, NothingIsSeenThroughAPolygonBehindTheEye) {
  const View view = Camera{.pose = lookAt({0, 0, 0}, {0, 0, -1})}.view();
  for (const float size : {1e-4f, 1.0f, 100.0f}) {
    const std::vector<glm::vec3> polygon = {
        {-size, -size, 2}, {size, -size, 2}, {size, size, 2}, {-size, size, 2}};
    EXPECT_TRUE(clipRegion(view, wholeScreen(view), polygon).empty());
  }
}

TEST(ScreenRegion, ContainsAndBoundingRegionAgree) {
  std::mt19937 random(5);
  int apart = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const View view = randomView(random, {0, 0, 0});
    const ScreenRegion screen = wholeScreen(view);
    const std::vector<ScreenRegion> two = {
        clipRegion(view, screen, randomPolygon(random, randomVector(random, 3))),
        clipRegion(view, screen, randomPolygon(random, randomVector(random, 3)))};
    if (two[0].empty() || two[1].empty()) continue;
    const ScreenRegion bounding = boundingRegion(view, two);
    EXPECT_TRUE(contains(bounding, two[0]));
    EXPECT_TRUE(contains(bounding, two[1]));
    EXPECT_TRUE(contains(screen, bounding));
    EXPECT_TRUE(contains(two[0], two[0]));
    if (!contains(two[0], two[1])) {
      ++apart;
      double least = 1;
      for (const glm::vec2& corner : two[1].corners) {
        least = std::min(least, depthInside(two[0], corner));
      }
      EXPECT_LT(least, 0);
    }
  }
  EXPECT_GT(apart, 20);
}

TEST(ScreenRegion, ABoxThatTouchesARegionIsNeverLostFarFromTheOrigin) {
  std::mt19937 random(6);
  int rejected = 0;
  for (const float offset : {0.0f, 100.0f, 3000.0f}) {
    for (int trial = 0; trial < 300; ++trial) {
      const glm::vec3 eye = randomVector(random, 3) + glm::vec3(offset, 0, -offset);
      View view = Camera{.pose = lookAt(eye, eye + randomVector(random, 1))}.view();
      const auto polygon = randomPolygon(random, eye + randomVector(random, 3));
      const ScreenRegion region = clipRegion(view, wholeScreen(view), polygon);
      if (region.empty()) continue;
      // On the region's border, just as far out as single precision goes.
      for (const glm::vec2& corner : region.corners) {
        const glm::vec3 p =
            eye + glm::vec3(directionOf(view, corner) * double(uniform(random, 0.3f, 200)));
        EXPECT_TRUE(mayBeSeen(region, Box{p, p + 0.1f}.grown(offset * 1e-6f + 1e-4f)));
      }
      const glm::vec3 center = eye + randomVector(random, 30);
      rejected += !mayBeSeen(region, Box{center, center}.grown(0.5f));
    }
  }
  EXPECT_GT(rejected, 100);
}

TEST(ScreenRegion, AnEmptyBoxIsNeverSeen) {
  const View view = Camera{}.view();
  EXPECT_FALSE(mayBeSeen(wholeScreen(view), Box{}));
  EXPECT_FALSE(mayBeSeen(ScreenRegion{}, Box{{-9, -9, -9}, {9, 9, 9}}));
}

}  // namespace
}  // namespace enfilade
