#include "ibr/portal_texture.h"

#include <gtest/gtest.h>

#include "analytic_scene.h"
#include "ibr/portal_frame.h"
#include "ibr/portal_ldi.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

TEST(PortalTexture, CoordinatesAreWhereTheCaptureSawTheCorners) {
  testing::Random random(71);
  ImageParameters parameters;
  parameters.image_size = 200;
  Portal gable = testing::doorway();
  gable.polygon = {{-0.5f, 0, 0}, {0.5f, 0.3f, 0}, {0.1f, 2.1f, 0}};
  for (const Portal& portal : {testing::doorway(), gable}) {
    for (const bool from_front : {true, false}) {
      const double side = from_front ? 1 : -1;
      const PlanarCamera camera = portalCamera(
          portal, from_front, {random(-1.0, 1.0), 1.6, side * random(0.4, 2.0)}, parameters);
      const auto coordinates =
          textureCoordinates(portal, from_front, parameters.portal_margin, portal.polygon);
      ASSERT_EQ(coordinates.size(), portal.polygon.size());
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const glm::dvec3 seen = projectPoint(camera, glm::dvec3(portal.polygon[i]));
        EXPECT_NEAR(static_cast<double>(coordinates[i].x), seen.x / camera.width, 1e-6);
        EXPECT_NEAR(static_cast<double>(coordinates[i].y), seen.y / camera.height, 1e-6);
      }
    }
  }
}

TEST(PortalTexture, HasTheRowsAskedForAndTheColoursOfItsCapture) {
  ImageParameters parameters;
  parameters.image_size = 64;
  parameters.portal_margin = 0;
  const testing::AnalyticScene room = testing::furnishedRoom();
  DepthImage seen;
  const Image texture = captureTexture(testing::doorway(), true, {0, 1.6, 1.5}, parameters,
                                       [&](const PlanarCamera& camera) {
                                         seen = testing::castImage(room, camera);
                                         return seen;
                                       });
  EXPECT_EQ(texture.height, 64);
  EXPECT_EQ(texture.rgba, seen.color.rgba);
}

TEST(PortalLdi, LookingAtItInTheMakingDoesNotChangeWhatItBecomes) {
  ImageParameters parameters;
  parameters.image_size = 32;
  parameters.rings = {{5, 75.0f, 0.0f}, {6, 62.5f, -0.5f}};
  const testing::AnalyticScene room = testing::furnishedRoom();
  const auto capture = [&](const PlanarCamera& camera) { return testing::castImage(room, camera); };
  const Portal doorway = testing::doorway();
  PortalLdi ldi(doorway, true, 1.6f, parameters);
  EXPECT_EQ(ldi.captures(), 11u);
  std::size_t samples = 0;
  while (!ldi.complete()) {
    ldi.captureNext(capture);
    const std::size_t so_far = ldi.finish().samples.size();
    EXPECT_GE(so_far, samples);
    samples = so_far;
  }
  EXPECT_EQ(ldi.captured(), ldi.captures());
  const Ldi whole = buildLdi(testing::doorway(), true, 1.6f, parameters, capture);
  const Ldi made = ldi.finish();
  ASSERT_EQ(made.samples.size(), whole.samples.size());
  for (std::size_t i = 0; i < made.samples.size(); ++i) {
    ASSERT_EQ(made.samples[i].place, whole.samples[i].place);
    ASSERT_EQ(made.samples[i].r, whole.samples[i].r);
  }
}

}  // namespace
}  // namespace enfilade
