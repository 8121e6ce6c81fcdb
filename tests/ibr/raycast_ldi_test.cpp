// Layered depth images by rays, in a small room of flat faces whose true visibility is worked out
// by other rays.
#include "ibr/raycast_ldi.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

#include "analytic_scene.h"
#include "ibr/capture_samples.h"
#include "ibr/portal_frame.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

constexpr double kFarDepth = 40.0;

/// Behind the doorway: a textured wall, a slanting screen before it, and behind the wall something
/// that nobody sees.
struct Scene {
  Building building;
  std::uint32_t wall, screen, hidden;

  Scene() {
    building.images.push_back({"", pattern(), {}, ""});
    Material textured = test::unlitMaterial({1, 1, 1, 1});
    textured.image = 0;
    wall = test::addQuad(building, test::rectangle({-12, -6}, {12, 8}, -3.0f), textured);
    Material green = test::unlitMaterial({0, 1, 0, 1});
    green.double_sided = true;
    screen = test::addQuad(building,
                           {glm::vec3(-0.4f, 0.2f, -0.5f), glm::vec3(0.3f, 0.2f, -1.7f),
                            glm::vec3(0.3f, 1.5f, -1.7f), glm::vec3(-0.4f, 1.5f, -0.5f)},
                           green);
    hidden = test::addQuad(building, test::rectangle({-3, -3}, {3, 5}, -4.0f),
                           test::unlitMaterial({1, 0, 1, 1}));
  }

  static Image pattern() {
    Image image;
    image.width = image.height = 64;
    for (int i = 0; i < 64 * 64; ++i) {
      image.rgba.insert(image.rgba.end(), {static_cast<std::uint8_t>(3 * (i % 64)),
                                           static_cast<std::uint8_t>(20 + i / 64), 40, 255});
    }
    return image;
  }
  ObjectsInView objects() const {
    return [this](const View&) { return test::allObjects(building); };
  }
};

ImageParameters smallImages() {
  ImageParameters parameters;
  parameters.image_size = 48;
  parameters.portal_margin = 0;
  return parameters;
}

Ldi made(const Scene& scene, const ImageParameters& parameters) {
  const RayCaster caster(scene.building, {}, 1);
  return raycastLdi(caster, testing::doorway(), true, 1.6f, parameters, scene.objects(), kFarDepth);
}

/// Every sample's point and pixel.
template <class Body>
void forEachSample(const Ldi& ldi, const Body& body) {
  for (const LdiTile& tile : ldi.tiles) {
    for (std::uint32_t i = tile.first; i < tile.first + tile.count; ++i) {
      const LdiSample& s = ldi.samples[i];
      const glm::dvec3 pixel(tile.x * kLdiTile + static_cast<double>(xInTile(s)),
                             tile.y * kLdiTile + static_cast<double>(yInTile(s)),
                             static_cast<double>(disparityOf(s)));
      body(s, unprojectPoint(ldi.camera, pixel));
    }
  }
}

bool isOnTheScreen(const LdiSample& s) { return s.g > 200 && s.r < 20; }

TEST(RaycastLdi, HoldsWhatSomeViewpointSeesThroughThePortalAndNothingElse) {
  const Scene scene;
  const ImageParameters parameters = smallImages();
  const auto viewpoints = captureViewpoints(testing::doorway(), true, 1.6f, parameters);
  const RayCaster caster(scene.building, {}, 1);
  const PortalFrame frame = portalFrame(testing::doorway(), true);
  std::size_t screens = 0, walls = 0, unseen = 0;
  forEachSample(made(scene, parameters), [&](const LdiSample& s, const glm::dvec3& point) {
    ASSERT_FALSE(s.r > 200 && s.b > 200) << "the hidden face is seen";
    (isOnTheScreen(s) ? screens : walls) += 1;
    bool seen = false;
    for (const glm::dvec3& eye : viewpoints) {
      const glm::dvec3 crossing = eye + (point - eye) * (eye.z / (eye.z - point.z));
      const bool through =
          std::abs(crossing.x) < frame.half_width + 0.05 && crossing.y > -0.05 && crossing.y < 2.15;
      const glm::dvec3 way = point - eye;
      const auto length = static_cast<float>(glm::length(way));
      const RayHit hit = caster.cast(glm::vec3(eye), glm::vec3(way) / length, 0, 50, false);
      // Samples are means over a pixel: at the edges of the screen they may miss by a little.
      seen = seen || (through && (hit.distance < 0 || hit.distance > 0.98f * length));
    }
    unseen += !seen;
  });
  EXPECT_GT(screens, 100u);
  EXPECT_GT(walls, 1000u);
  EXPECT_LT(unseen, (screens + walls) / 200);
}

TEST(RaycastLdi, HasTheWallBehindTheScreenWhereOthersSeeIt) {
  const Scene scene;
  const Ldi ldi = made(scene, smallImages());
  const glm::dvec3 pixel = projectPoint(ldi.camera, {-0.05, 0.85, -1.1});
  const auto layers = layersAt(ldi, static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_TRUE(isOnTheScreen(layers[0]));
  EXPECT_NEAR(static_cast<double>(disparityOf(layers[1])), 1.5 / 4.5, 1e-4);
}

TEST(RaycastLdi, ShadesItsFirstLayerAsTheCentralCaptureDoes) {
  const Scene scene;
  const ImageParameters parameters = smallImages();
  const Ldi ldi = made(scene, parameters);
  Renderer renderer(test::sharedContext(), scene.building);
  const auto center = captureViewpoints(testing::doorway(), true, 1.6f, parameters)[0];
  const PlanarCamera camera = portalCamera(testing::doorway(), true, center, parameters);
  const CaptureSamples capture = resolveCapture(
      captureThroughPortal(renderer, refined(camera, parameters.rays), scene.objects(), kFarDepth),
      parameters.rays, 0.01f);
  const glm::dvec3 corner = projectPoint(ldi.camera, unprojectPoint(camera, {0, 0, 1}));
  std::size_t compared = 0, off = 0;
  for (const CaptureSample& s : capture.samples) {
    if (s.width < 1 || s.height < 1) continue;
    const auto layers = layersAt(ldi, static_cast<int>(corner.x + 0.5) + static_cast<int>(s.u),
                                 static_cast<int>(corner.y + 0.5) + static_cast<int>(s.v));
    ASSERT_FALSE(layers.empty());
    ++compared;
    off += std::abs(layers[0].r - s.r) > 3 || std::abs(layers[0].g - s.g) > 3 ||
           std::abs(disparityOf(layers[0]) - s.disparity) > 1e-4f;
  }
  EXPECT_GT(compared, 800u);
  EXPECT_LE(off, compared / 100);
}

TEST(RaycastLdi, TintsWhatIsSeenThroughGlass) {
  Scene scene;
  Material glass = test::unlitMaterial({0, 0, 1, 0.5f});
  glass.alpha_mode = AlphaMode::kBlend;
  glass.double_sided = true;
  const Ldi plain = made(scene, smallImages());
  test::addQuad(scene.building, test::rectangle({-3, -3}, {3, 5}, -0.2f), glass);
  const Ldi tinted = made(scene, smallImages());
  ASSERT_EQ(plain.samples.size(), tinted.samples.size());
  for (std::size_t i = 0; i < plain.samples.size(); ++i) {
    ASSERT_EQ(plain.samples[i].place, tinted.samples[i].place) << "the glass is no sample itself";
    ASSERT_NEAR(tinted.samples[i].r, 0.5 * plain.samples[i].r, 2);
    ASSERT_NEAR(tinted.samples[i].b, 0.5 * plain.samples[i].b + 127.5, 2);
  }
}

TEST(RaycastLdi, ShowsTheSkyWhereNothingIs) {
  const Building empty;
  const RayCaster caster(empty, {}, 1);
  ImageParameters parameters = smallImages();
  parameters.ldi_half_width = 2.0f;
  const Ldi ldi = raycastLdi(
      caster, testing::doorway(), true, 1.6f, parameters,
      [](const View&) { return std::vector<std::uint32_t>(); }, kFarDepth);
  ASSERT_GT(ldi.samples.size(), 48u * 23u);
  for (const LdiSample& s : ldi.samples) {
    EXPECT_EQ(s.b, kSkyColor[2]);
    EXPECT_NEAR(disparityOf(s), 1.5f / 40.0f, 1e-4f);
  }
}

TEST(RaycastLdi, IsTheSameForAnyNumberOfThreads) {
  const Scene scene;
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return made(scene, smallImages());
  };
  const Ldi one = with(1);
  const Ldi four = with(4);
  ASSERT_EQ(one.samples.size(), four.samples.size());
  EXPECT_EQ(std::memcmp(one.samples.data(), four.samples.data(), 8 * one.samples.size()), 0);
}

}  // namespace
}  // namespace enfilade
