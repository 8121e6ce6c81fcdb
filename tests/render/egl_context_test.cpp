// EGL's contexts beside OSMesa's.  Where a machine has no EGL these tests skip, and say why.

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "render/renderer.h"
#include "scene/error.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 500;
constexpr int kHeight = 400;

class EglContext : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      egl_ = createEglContext(2);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kMachine);
      EXPECT_NE(std::string(error.what()).find("--gl osmesa"), std::string::npos) << error.what();
      GTEST_SKIP() << error.what();
    }
  }

  static DepthPicture pictureOf(Renderer& renderer, const Building& building) {
    DepthPicture picture;
    renderer.begin(kWidth, kHeight);
    renderer.draw(allObjects(building), frontCamera(kWidth, kHeight).view());
    renderer.readColor(picture.color);
    renderer.readDepth(picture.depth);
    return picture;
  }

  static DepthPicture pictureBy(GlContext& context, const Building& building) {
    Renderer renderer(context, building);
    return pictureOf(renderer, building);
  }

  std::unique_ptr<GlContext> egl_;
};

/// The share of values that differ by more than `tolerance`.
template <typename T>
double shareOff(const std::vector<T>& a, const std::vector<T>& b, double tolerance) {
  std::size_t off = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) > tolerance) ++off;
  }
  return static_cast<double>(off) / static_cast<double>(a.size());
}

TEST_F(EglContext, DrawsThePicturesThatOsMesaDraws) {
  const Building building = tunnel();
  const DepthPicture expected = pictureBy(*createOsMesaContext(2), building);
  const DepthPicture drawn = pictureBy(*egl_, building);
  ASSERT_EQ(drawn.color.rgba.size(), expected.color.rgba.size());
  // Pixels on edges may fall to the other side, and colours between two levels.
  EXPECT_LT(shareOff(drawn.color.rgba, expected.color.rgba, 2), 0.01) << egl_->description();
  EXPECT_LT(shareOff(drawn.depth, expected.depth, 1e-5), 0.01) << egl_->description();
}

TEST_F(EglContext, TakesTurnsWithOsMesaOnOneThread) {
  const Building building = tunnel();
  const auto osmesa = createOsMesaContext(2);
  Renderer by_osmesa(*osmesa, building);
  Renderer by_egl(*egl_, building);
  const DepthPicture first_by_osmesa = pictureOf(by_osmesa, building);
  const DepthPicture first_by_egl = pictureOf(by_egl, building);
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(pictureOf(by_osmesa, building).color.rgba, first_by_osmesa.color.rgba);
    EXPECT_EQ(pictureOf(by_egl, building).color.rgba, first_by_egl.color.rgba);
  }
  by_osmesa.begin(kWidth, kHeight);  // which only begins, but is current now
  Image still_there;
  by_egl.readColor(still_there);
  EXPECT_EQ(still_there.rgba, first_by_egl.color.rgba);
}

TEST_F(EglContext, DrawsOnSeveralThreadsAtOnceEachWithItsOwn) {
  const Building building = tunnel();
  const DepthPicture expected = pictureBy(*egl_, building);
  std::vector<DepthPicture> pictures(3);
  std::vector<std::thread> threads;
  for (DepthPicture& picture : pictures) {
    threads.emplace_back([&] { picture = pictureBy(*createEglContext(2), building); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const DepthPicture& picture : pictures) EXPECT_EQ(picture.color.rgba, expected.color.rgba);
}

TEST_F(EglContext, SaysWhatDrawsInItsDescription) {
  EXPECT_NE(egl_->description().find("OpenGL"), std::string::npos);
  EXPECT_TRUE(egl_->description().ends_with(" by EGL")) << egl_->description();
}

}  // namespace
}  // namespace enfilade
