// LdiBuilder against its rules as they are written.
#include "plain_ldi.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "analytic_scene.h"
#include "ibr/portal_capture.h"

namespace enfilade {
namespace {

/// Sample for sample; the plain one knows no window.
void expectEqual(const Ldi& built, const Ldi& plain) {
  ASSERT_EQ(built.samples.size(), plain.samples.size());
  EXPECT_EQ(std::memcmp(built.samples.data(), plain.samples.data(), 8 * plain.samples.size()), 0);
  ASSERT_EQ(built.tiles.size(), plain.tiles.size());
  for (std::size_t i = 0; i < plain.tiles.size(); ++i) {
    ASSERT_EQ(built.tiles[i].count, plain.tiles[i].count) << "tile " << i;
  }
}

Ldi built(const PlanarCamera& central, const LdiRules& rules,
          const std::vector<CaptureSamples>& captures) {
  LdiBuilder builder(central, rules);
  for (const CaptureSamples& capture : captures) builder.insert(capture);
  return builder.finish();
}

TEST(LdiBuilder, BuildsOfARoomWhatItsRulesSay) {
  const testing::AnalyticScene room = testing::furnishedRoom();
  ImageParameters parameters;
  parameters.image_size = 64;
  const auto viewpoints = captureViewpoints(testing::doorway(), true, 1.6f, parameters);
  const PlanarCamera central = portalCamera(testing::doorway(), true, viewpoints[0], parameters);
  for (const int rays : {1, 2}) {
    for (const LdiRules& rules : {LdiRules{0.5f, 16.0f}, LdiRules{3.0f, 1.5f}}) {
      std::vector<CaptureSamples> captures;
      for (const glm::dvec3& at : viewpoints) {
        const PlanarCamera camera = portalCamera(testing::doorway(), true, at, parameters);
        captures.push_back(resolveCapture(testing::castImage(room, refined(camera, rays)), rays,
                                          disparityThreshold(central, rules.depth_threshold)));
      }
      expectEqual(built(central, rules, captures), testing::plainLdi(central, rules, captures));
    }
  }
}

TEST(LdiBuilder, BuildsOfCrowdedPixelsWhatItsRulesSay) {
  // Twelve captures of few pixels and many depths, so that most samples meet others, some exactly.
  std::mt19937 random(11);
  const auto among = [&](int n) { return static_cast<float>(random() % static_cast<unsigned>(n)); };
  std::vector<CaptureSamples> captures;
  for (int i = 0; i < 12; ++i) {
    PlanarCamera camera;
    camera.center = {0.1 * i, 0, 2};
    camera.world_from_pixel =
        glm::dmat3({0.01, 0, 0}, {0, -0.01, 0}, glm::dvec3(-0.16, 0.16, 0) - camera.center);
    camera.width = camera.height = 32;
    CaptureSamples capture{camera, {}};
    for (int k = 0; k < 3000; ++k) {
      CaptureSample s;
      s.u = 12.5f + among(8);
      s.v = 12.5f + among(8);
      s.disparity = 0.5f + 0.002f * among(20);
      s.slope_u = 0.001f * among(4);
      s.doubt = 1.0f + among(2);
      s.r = static_cast<std::uint8_t>(random());
      capture.samples.push_back(s);
    }
    captures.push_back(capture);
  }
  const PlanarCamera central = captures[0].camera;
  const Ldi ldi = built(central, {1.0f, 4.0f}, captures);
  EXPECT_GT(samplesPerLayer(ldi).size(), 5u);
  expectEqual(ldi, testing::plainLdi(central, {1.0f, 4.0f}, captures));
}

}  // namespace
}  // namespace enfilade
