#include "ibr/portal_capture.h"

#include <gtest/gtest.h>

#include <cstring>

#include "analytic_scene.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

/// Behind the doorway's plane z = 0: a red wall, and a green one that slants before it; before the
/// plane a white screen that must not be seen.
struct TwoWalls {
  Building building;
  glm::dvec3 slant_normal;
  double slant_d;

  TwoWalls() {
    test::addQuad(building, test::rectangle({-60, -60}, {60, 60}, -3.0f),
                  test::unlitMaterial({1, 0, 0, 1}));
    const std::array<glm::vec3, 4> slant = {
        glm::vec3(-0.4f, 0.2f, -0.5f), glm::vec3(0.3f, 0.2f, -1.7f), glm::vec3(0.3f, 1.5f, -1.7f),
        glm::vec3(-0.4f, 1.5f, -0.5f)};
    Material green = test::unlitMaterial({0, 1, 0, 1});
    green.double_sided = true;
    test::addQuad(building, slant, green);
    test::addQuad(building, test::rectangle({-9, -9}, {9, 9}, 0.3f),
                  test::unlitMaterial({1, 1, 1, 1}));
    const glm::dvec3 a(slant[0]);
    slant_normal = glm::cross(glm::dvec3(slant[1]) - a, glm::dvec3(slant[3]) - a);
    slant_d = -glm::dot(slant_normal, a);
  }

  ObjectsInView objects() const {
    return [this](const View&) { return test::allObjects(building); };
  }
};

TEST(PortalCapture, SeesDisparitiesToFloatPrecision) {
  const TwoWalls scene;
  Renderer renderer(test::sharedContext(), scene.building);
  ImageParameters parameters;
  parameters.image_size = 128;
  int walls = 0, slants = 0;
  for (const glm::dvec3& at : captureViewpoints(testing::doorway(), true, 1.6f, parameters)) {
    const PlanarCamera camera = portalCamera(testing::doorway(), true, at, parameters);
    const DepthImage image = captureThroughPortal(renderer, camera, scene.objects(), 40.0);
    ASSERT_EQ(image.color.width, camera.width);
    ASSERT_EQ(image.disparity.size(), static_cast<std::size_t>(camera.width * camera.height));
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const auto pixel = static_cast<std::size_t>(y * camera.width + x);
        const glm::dvec3 ray = camera.world_from_pixel * glm::dvec3(x + 0.5, y + 0.5, 1);
        const bool slant = image.color.rgba[4 * pixel + 1] > 200;
        const double wall_disparity = ray.z / (-3.0 - camera.center.z);
        const double slant_disparity =
            -glm::dot(scene.slant_normal, ray) /
            (glm::dot(scene.slant_normal, camera.center) + scene.slant_d);
        (slant ? slants : walls) += 1;
        ASSERT_EQ(image.color.rgba[4 * pixel + 2], 0) << "the screen before the portal is seen";
        // A float's depth has a step of 6e-8 near 1; vertices and interpolation have a few of them.
        ASSERT_NEAR(static_cast<double>(image.disparity[pixel]),
                    slant ? slant_disparity : wall_disparity, 1e-6)
            << x << "," << y;
      }
    }
  }
  EXPECT_GT(walls, 10000);
  EXPECT_GT(slants, 10000);
}

TEST(PortalCapture, GivesTheSkyAVerySmallDisparity) {
  const Building empty;
  Renderer renderer(test::sharedContext(), empty);
  const PlanarCamera camera = portalCamera(testing::doorway(), true, {0, 1.6, 1.5}, {});
  const DepthImage image = captureThroughPortal(
      renderer, camera, [](const View&) { return std::vector<std::uint32_t>(); }, 150.0);
  for (const float disparity : image.disparity) {
    ASSERT_NEAR(disparity, 0.01f, 1e-6f);
  }
  EXPECT_EQ(std::memcmp(image.color.rgba.data(), kSkyColor, 4), 0);
}

TEST(PortalCapture, AsksForTheObjectsOfItsOwnView) {
  const TwoWalls scene;
  Renderer renderer(test::sharedContext(), scene.building);
  const PlanarCamera camera = portalCamera(testing::doorway(), true, {1, 1.6, 1.5}, {});
  View asked;
  captureThroughPortal(
      renderer, camera,
      [&](const View& view) {
        asked = view;
        return test::allObjects(scene.building);
      },
      40.0);
  EXPECT_EQ(asked.eye, glm::vec3(1, 1.6f, 1.5f));
  EXPECT_EQ(asked.clip_from_world, viewOf(camera, 40.0).clip_from_world);
}

TEST(BakeLdi, MakesTheSameLdiRunAfterRun) {
  const TwoWalls scene;
  ImageParameters parameters;
  parameters.image_size = 64;
  const auto bake = [&] {
    Renderer renderer(test::sharedContext(), scene.building);
    return bakeLdi(renderer, testing::doorway(), true, 1.6f, parameters, scene.objects(), 40.0);
  };
  const Ldi a = bake();
  const Ldi b = bake();
  ASSERT_GT(a.samples.size(), 1000u);
  ASSERT_EQ(a.samples.size(), b.samples.size());
  EXPECT_EQ(std::memcmp(a.samples.data(), b.samples.data(), 8 * a.samples.size()), 0);
}

TEST(BakeLdi, HoldsBothSurfacesWhereOneHidesTheOther) {
  const TwoWalls scene;
  Renderer renderer(test::sharedContext(), scene.building);
  ImageParameters parameters;
  parameters.image_size = 64;
  const Ldi ldi =
      bakeLdi(renderer, testing::doorway(), true, 1.6f, parameters, scene.objects(), 40.0);
  // A point in the slanting wall's middle, and the wall behind it.
  const glm::dvec3 pixel = projectPoint(ldi.camera, {-0.05, 0.85, -1.1});
  const auto layers = layersAt(ldi, static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  ASSERT_GE(layers.size(), 2u);
  EXPECT_GT(layers.front().g, 200);
  EXPECT_GT(layers.back().r, 200);
  EXPECT_NEAR(static_cast<double>(disparityOf(layers.front())), pixel.z, 0.01);
  EXPECT_NEAR(static_cast<double>(disparityOf(layers.back())), 1.5 / 4.5, 0.002);
}

TEST(BuildLdi, KnowsNothingOfWhatLiesBesideThePortal) {
  // A triangular portal in the doorway's rectangle: captures see more than the portal shows.
  Portal gable = testing::doorway();
  gable.polygon = {{-0.5f, 0, 0}, {0.5f, 0, 0}, {0, 2.1f, 0}};
  ImageParameters parameters;
  parameters.image_size = 64;
  parameters.rings = {{1, 0.0f, 0.0f}};
  parameters.portal_margin = 0;
  const auto flat = [](const PlanarCamera& camera) {
    DepthImage image;
    image.camera = camera;
    image.color.width = camera.width;
    image.color.height = camera.height;
    const auto pixels = static_cast<std::size_t>(camera.width * camera.height);
    image.color.rgba.assign(4 * pixels, 50);
    image.disparity.assign(pixels, 0.5f);
    return image;
  };
  const Ldi triangle = buildLdi(gable, true, 1.6f, parameters, flat);
  const Ldi rectangle = buildLdi(testing::doorway(), true, 1.6f, parameters, flat);
  const double share =
      static_cast<double>(triangle.samples.size()) / static_cast<double>(rectangle.samples.size());
  EXPECT_NEAR(share, 0.5, 0.03);
  EXPECT_TRUE(layersAt(triangle, 1, 2).empty());
  EXPECT_FALSE(layersAt(rectangle, 1, 2).empty());
}

}  // namespace
}  // namespace enfilade
