// Baked light against what can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "preprocess/spherical_triangle.h"
#include "tests/preprocess/light_room.h"

namespace enfilade {
namespace {

constexpr float kPi = glm::pi<float>();

/// Form factor of a rectangle parallel to a small face, one corner straight above it.
/// Source: Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3.
double cornerFormFactor(double width, double depth, double away) {
  const double a = width / away, b = depth / away;
  const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / glm::two_pi<double>();
}

TEST(LightGather, UnderAnEvenSkyEveryFaceOfAConvexBodyHasPi) {
  LightRoom room(0);
  // The faces of the box, looking outwards.
  room.box({1, 2, 3});
  for (Mesh& mesh : room.building.meshes) std::swap(mesh.indices[1], mesh.indices[2]);
  for (Mesh& mesh : room.building.meshes) std::swap(mesh.indices[4], mesh.indices[5]);
  for (VertexArrays& arrays : room.building.vertex_arrays) {
    for (glm::vec3& n : arrays.normals) n = -n;
  }
  LightParameters parameters;
  parameters.sky = evenSky(1);
  const RoomLight lit = lightOf(room.building, {}, parameters);
  for (const glm::vec3& e : lit.light) EXPECT_NEAR(e.r, kPi, 1e-3);
}

TEST(LightGather, ALampLightsByTheCosineAndTheSquareOfTheDistance) {
  LightRoom room(0);
  room.box({4, 3, 4});
  const glm::vec3 lamp(1.5f, 2, 2.2f);
  room.lamp(lamp, 100);
  LightParameters parameters;
  parameters.rays = parameters.detail_rays = 16;
  const RoomLight lit = lightOf(room.building, {}, parameters);
  ASSERT_GT(lit.light.size(), 500u);
  for (std::size_t i = 0; i < lit.light.size(); ++i) {
    const glm::vec3 way = lamp - lit.points.positions[i];
    const float d = glm::length(way);
    const float expected = 100 * glm::dot(way, lit.points.normals[i]) / (d * d * d);
    EXPECT_NEAR(lit.light[i].r, expected, 0.01f * expected + 0.05f);
  }
}

TEST(LightGather, WhatStandsBetweenThrowsAShadow) {
  LightRoom room(0);
  room.face({-3, 0, -3}, {-3, 0, 3}, {3, 0, -3});
  room.face({-0.5f, 1, -0.5f}, {-0.5f, 1, 0.5f}, {0.5f, 1, -0.5f});
  room.lamp({0, 2, 0}, 100);
  LightParameters parameters;
  parameters.sky = evenSky(0);
  const RoomLight lit = lightOf(room.building, {}, parameters);
  for (std::size_t i = 0; i < lit.light.size(); ++i) {
    const glm::vec3& p = lit.points.positions[i];
    if (p.y > 0.5f) continue;
    const float across = std::max(std::abs(p.x), std::abs(p.z));
    if (across < 0.85f) {
      EXPECT_EQ(lit.light[i].r, 0.0f);
    } else if (across > 1.2f) {
      EXPECT_GT(lit.light[i].r, 1.0f);
    }
  }
}

TEST(LightGather, AWindowLightsByItsFormFactor) {
  LightRoom room(0);
  room.face({0, 0, 0}, {0, 0, 4}, {4, 0, 0});
  // A skylight, the only way to the sky; a black room has no other light.
  const float width = 1.5f, depth = 1, high = 2.5f;
  const glm::vec3 from(1, high, 1.5f);
  const std::vector<SkyPortal> portals = {
      {{from, from + glm::vec3(width, 0, 0), from + glm::vec3(width, 0, depth),
        from + glm::vec3(0, 0, depth)},
       {0, -1, 0}}};
  // The rest of the ceiling, from below and above.
  const auto ceiling = [&](float x0, float z0, float x1, float z1) {
    room.face({x0, high, z0}, {x1, high, z0}, {x0, high, z1});
  };
  ceiling(-90, -90, 90, 1.5f);
  ceiling(-90, 2.5f, 90, 90);
  ceiling(-90, 1.5f, 1, 2.5f);
  ceiling(2.5f, 1.5f, 90, 2.5f);
  LightParameters parameters;
  parameters.longest_edge = 0;
  parameters.sky = {glm::vec3(1), glm::vec3(1), glm::vec3(0)};
  splitLongEdges(room.building, std::vector<MeshToSplit>{{0, glm::mat4(1)}}, 0.5f, 1000);
  const RoomLight lit = lightOf(room.building, portals, parameters);
  const auto factor = [&](double x, double z) {
    // Four corners about the point's foot, with the signs of the sides they are on.
    const auto part = [&](double w, double d) {
      return std::copysign(1, w) * std::copysign(1, d) *
             cornerFormFactor(std::abs(w), std::abs(d), static_cast<double>(high));
    };
    return part(2.5 - x, 2.5 - z) - part(1 - x, 2.5 - z) - part(2.5 - x, 1.5 - z) +
           part(1 - x, 1.5 - z);
  };
  int compared = 0;
  for (std::size_t i = 0; i < lit.light.size(); ++i) {
    const glm::vec3& p = lit.points.positions[i];
    if (p.y > 1) continue;
    ++compared;
    EXPECT_NEAR(lit.light[i].r, glm::pi<double>() * factor(p.x, p.z), 0.005) << p.x << " " << p.z;
  }
  EXPECT_GT(compared, 80);
}

TEST(LightGather, InAClosedGreyRoomReflectionsAddUpToOneOverOneMinusAlbedo) {
  // What a lamp puts into a closed room is taken up by its walls: the mean illuminance by area is
  // the direct one's over (1 − albedo).
  for (const float albedo : {0.3f, 0.6f}) {
    LightRoom room(albedo);
    room.box({4, 3, 5});
    room.lamp({2, 1.5f, 2.5f}, 100);
    LightParameters parameters;
    parameters.bounces = 40;
    const RoomLight lit = lightOf(room.building, {}, parameters);
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < lit.light.size(); ++i) {
      sum += static_cast<double>(lit.light[i].r * lit.points.areas[i]);
      area += static_cast<double>(lit.points.areas[i]);
    }
    const double flux = 4 * glm::pi<double>() * 100;
    const double expected = flux / area / (1 - static_cast<double>(albedo));
    EXPECT_NEAR(sum / area, expected, 0.02 * expected) << albedo;
  }
}

TEST(LightGather, IsTheSameForAnyNumberOfThreads) {
  LightRoom room(0.5f);
  room.box({3, 3, 3});
  room.lamp({1, 2, 1}, 50);
  LightParameters parameters;
  parameters.longest_edge = 0.1f;
  parameters.threads = 1;
  const RoomLight one = lightOf(room.building, {}, parameters);
  parameters.threads = 3;
  EXPECT_EQ(lightOf(room.building, {}, parameters).light, one.light);
}

TEST(LightGather, KeepsItsLinksWithinBounds) {
  LightRoom room(0.5f);
  room.box({3, 3, 3});
  Building building = room.building;
  splitLongEdges(building, 0.3f);
  const LightRays rays(building, {}, {});
  const LightPoints points = makeLightPoints(building, rays.surfaces().world());
  const LightSides sides = chooseSides(building, points, rays, 1);
  LightParameters parameters;
  parameters.most_links = 20 * points.size();
  EXPECT_LE(gatherLight(building, points, sides, rays, {}, parameters, {}).links,
            parameters.most_links);
}

TEST(SphericalTriangle, ItsDirectionsMakeItsCosineIntegral) {
  const glm::vec3 n = glm::normalize(glm::vec3(0.2f, 1, 0.1f));
  const std::vector<glm::vec3> corners = {{-1, 1, 0.3f}, {2, 0.7f, 1}, {0.5f, 1.5f, -2}};
  const SphericalTriangle triangle(corners[0], corners[1], corners[2]);
  double sum = 0;
  constexpr int kSide = 100;
  for (int i = 0; i < kSide * kSide; ++i) {
    const float s = (static_cast<float>(i % kSide) + 0.5f) / kSide;
    const float t = (static_cast<float>(i / kSide) + 0.5f) / kSide;
    const glm::vec3 d = triangle.direction(s, t);
    sum += static_cast<double>(glm::dot(d, n));
    // Within the triangle: on the inner side of the three planes through the origin.
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 side = glm::cross(corners[k], corners[(k + 1) % 3]);
      EXPECT_GE(glm::dot(side, d) * glm::dot(side, corners[(k + 2) % 3]), -1e-5f);
    }
  }
  EXPECT_NEAR(sum / (kSide * kSide) * static_cast<double>(triangle.solidAngle()),
              cosineIntegral(corners, glm::vec3(0), n), 1e-3);
}

}  // namespace
}  // namespace enfilade
