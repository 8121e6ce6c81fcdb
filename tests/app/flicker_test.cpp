#include "app/flicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace enfilade {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr std::size_t kPixels = kWidth * kHeight;

Camera cameraAt(const glm::vec3& eye, float yaw = 0) {
  Camera camera;
  camera.pose = poseFromAngles(eye, yaw, 0);
  camera.aspect = static_cast<float>(kWidth) / kHeight;
  return camera;
}

/// The distance at which a ray from the eye meets the wall z = −4, which reaches over all.
constexpr float kWall = -4;

/// What `camera` sees of that wall, by projecting in double precision.
DepthView viewOfWall(const Camera& camera) {
  DepthView view{camera, {}};
  const glm::dmat4 clip_from_world(camera.clipFromWorld());
  const glm::dmat4 world_from_clip = glm::inverse(clip_from_world);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      glm::dvec4 far = world_from_clip *
                       glm::dvec4(2 * (x + 0.5) / kWidth - 1, 1 - 2 * (y + 0.5) / kHeight, 1, 1);
      far /= far.w;
      const glm::dvec3 eye(camera.pose.position);
      const glm::dvec3 ray = glm::dvec3(far) - eye;
      const glm::dvec4 hit(eye + ray * ((kWall - eye.z) / ray.z), 1);
      const glm::dvec4 clip = clip_from_world * hit;
      view.depth.push_back(static_cast<float>(0.5 + 0.5 * clip.z / clip.w));
    }
  }
  return view;
}

Image uniform(std::uint8_t value) {
  return {kWidth, kHeight, std::vector<std::uint8_t>(4 * kPixels, value)};
}

PictureError errorBetween(const Image& picture, const Image& truth) {
  PictureError error;
  errorOf(picture, truth, error);
  return error;
}

TEST(Flicker, OfFramesThatAreTheTruthIsNone) {
  const DepthView view = viewOfWall(cameraAt({0, 0, 0}));
  const FrameMotion motion =
      motionBetween(view, viewOfWall(cameraAt({0.3f, 0, 0.1f})), kWidth, kHeight);
  const PictureError none = errorBetween(uniform(80), uniform(80));
  EXPECT_EQ(flicker(motion, none, none), 0.0);
}

TEST(Flicker, OfOneBlinkingPixelIsItsShareOfTheFrame) {
  const DepthView view = viewOfWall(cameraAt({0, 0, 0}));
  const FrameMotion motion = motionBetween(view, view, kWidth, kHeight);
  Image blinking = uniform(80);
  const std::size_t pixel = 20 * kWidth + 30;
  blinking.rgba[4 * pixel] = 110;     // red by 30
  blinking.rgba[4 * pixel + 2] = 74;  // blue by −6
  blinking.rgba[4 * pixel + 3] = 0;   // alpha is not looked at
  const PictureError none = errorBetween(uniform(80), uniform(80));
  const PictureError lit = errorBetween(blinking, uniform(80));
  const double right = (30.0 + 6.0) / 3.0 / static_cast<double>(kPixels);
  EXPECT_NEAR(flicker(motion, lit, none).value(), right, 0.01 * right);
  EXPECT_NEAR(flicker(motion, none, lit).value(), right, 0.01 * right);
}

TEST(Flicker, OfAnErrorThatStaysOnAStillScreenIsNone) {
  const DepthView view = viewOfWall(cameraAt({0, 0, 0}));
  const FrameMotion motion = motionBetween(view, view, kWidth, kHeight);
  std::mt19937 random(3);
  Image noisy = uniform(80);
  for (std::uint8_t& byte : noisy.rgba) byte = static_cast<std::uint8_t>(random() % 256);
  const PictureError error = errorBetween(noisy, uniform(80));
  EXPECT_NEAR(flicker(motion, error, error).value(), 0, 0.02);
}

TEST(Flicker, MotionIsThatOfTheSurfaceProjectedIntoTheFrameBefore) {
  const Camera before = cameraAt({0, 0, 0}, 0.02f);
  const Camera now = cameraAt({0.4f, 0.1f, -0.5f}, -0.05f);
  const FrameMotion motion = motionBetween(viewOfWall(before), viewOfWall(now), kWidth, kHeight);
  int in_sight = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::vec2 place = motion.before[static_cast<std::size_t>(y * kWidth + x)];
      // The pixel's ray in camera space, to the wall, and into the camera before.
      const double half = std::tan(0.5 * static_cast<double>(now.vertical_fov));
      const glm::dvec4 ray((2 * (x + 0.5) / kWidth - 1) * half * static_cast<double>(now.aspect),
                           (1 - 2 * (y + 0.5) / kHeight) * half, -1, 0);
      const glm::dvec3 along(glm::dmat4(now.worldFromCamera()) * ray);
      const glm::dvec3 eye(now.pose.position);
      const glm::dvec3 point = eye + along * ((kWall - eye.z) / along.z);
      const glm::dvec3 seen(glm::dmat4(before.cameraFromWorld()) * glm::dvec4(point, 1));
      const double right =
          0.5 * kWidth * (1 - seen.x / seen.z / half / static_cast<double>(now.aspect));
      const double down = 0.5 * kHeight * (1 + seen.y / seen.z / half);
      const bool inside = right > 0 && down > 0 && right < kWidth && down < kHeight;
      if (!inside) {
        EXPECT_LT(place.x, 0) << x << ", " << y;
        continue;
      }
      ++in_sight;
      ASSERT_NEAR(static_cast<double>(place.x), right, 0.01) << x << ", " << y;
      ASSERT_NEAR(static_cast<double>(place.y), down, 0.01) << x << ", " << y;
    }
  }
  EXPECT_GT(in_sight, 2000);
}

TEST(Flicker, AnErrorThatMovesWithItsSurfaceCountsLessThanOneThatStaysOnTheScreen) {
  // Four pixels to the side on the wall at 4 m.
  const Camera before = cameraAt({0, 0, 0});
  const float pixel = 2 * 4 * std::tan(0.5f * before.vertical_fov) / kHeight;
  const Camera now = cameraAt({4 * pixel, 0, 0});
  const FrameMotion motion = motionBetween(viewOfWall(before), viewOfWall(now), kWidth, kHeight);
  PictureError old(kPixels, glm::i16vec3(0)), moved = old;
  for (std::size_t y = 10; y < 30; ++y) {
    for (std::size_t x = 20; x < 40; ++x) {
      old[y * kWidth + x] = glm::i16vec3(50);
      moved[y * kWidth + x - 4] = glm::i16vec3(50);
    }
  }
  EXPECT_NEAR(flicker(motion, moved, old).value(), 0, 0.02);
  // Eight columns of twenty rows change by 50, of the columns that were in sight.
  EXPECT_NEAR(flicker(motion, old, old).value(), 8 * 20 * 50.0 / ((kWidth - 4) * kHeight), 0.02);
}

TEST(Flicker, WhatWasHiddenBeforeIsNotCounted) {
  DepthView before = viewOfWall(cameraAt({0, 0, 0}));
  const DepthView now = before;
  // The left half was hidden by something near.
  for (std::size_t i = 0; i < kPixels; ++i) {
    if (i % kWidth < kWidth / 2) before.depth[i] = 0.9f;
  }
  const FrameMotion motion = motionBetween(before, now, kWidth, kHeight);
  PictureError none(kPixels, glm::i16vec3(0)), left = none;
  for (std::size_t i = 0; i < kPixels; ++i) {
    if (i % kWidth < kWidth / 2 - 1) left[i] = glm::i16vec3(90);
  }
  EXPECT_NEAR(flicker(motion, left, none).value(), 0, 0.01);
}

TEST(Flicker, HasNoValueWhereNothingWasInSight) {
  const DepthView view = viewOfWall(cameraAt({0, 0, 0}));
  DepthView hidden = view;
  std::fill(hidden.depth.begin(), hidden.depth.end(), 0.5f);
  const FrameMotion motion = motionBetween(hidden, view, kWidth, kHeight);
  const PictureError none(kPixels, glm::i16vec3(0));
  EXPECT_FALSE(flicker(motion, none, none));
}

}  // namespace
}  // namespace enfilade
