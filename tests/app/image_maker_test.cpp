// Baked images and those made on demand, on a house of two rooms in many colours.
#include "app/image_maker.h"

#include <gtest/gtest.h>

#include <cstring>

#include "app/frame_painter.h"
#include "ibr/convex_region.h"
#include "portals/polygon.h"
#include "tests/app/baked_rooms.h"

namespace enfilade {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 128;

class ImagesTest : public testing::BakedRooms {
 protected:
  /// A camera that looks at the doorway from one of the side's texture viewpoints.
  static Camera cameraAt(const glm::dvec3& eye) {
    Camera camera = walkingCamera(*house_, 1.2f, kWidth, kHeight);
    camera.pose = lookAt(glm::vec3(eye), glm::vec3(4.1f, 1.2f, 2.0f));
    return camera;
  }
  static const SideImages& front() { return std::as_const(*baked_).side(0, true); }

  static Image painted(FramePainter& painter, Method method, const Camera& camera) {
    painter.paint(method, camera);
    Image picture;
    painter.read(picture);
    return picture;
  }
};

const Method kImageMethods[] = {Method::kTexture, Method::kWarp, Method::kWarp2, Method::kLdi};

TEST_F(ImagesTest, EverySideHasAllItsImagesAndOnlyTheKindsAskedForAreRead) {
  EXPECT_EQ(baked_->count(ImageKind::kTexture), 2u * 5u);
  EXPECT_EQ(baked_->count(ImageKind::kReference), 2u * 6u);
  EXPECT_EQ(baked_->count(ImageKind::kLdi), 2u);
  const PortalImages some(*house_, here_->path(), {false, true, false});
  EXPECT_EQ(some.count(ImageKind::kReference), some.count());
  EXPECT_EQ(some.count(), 12u);
  const ImageCounts counts = countImages(*house_);
  EXPECT_EQ(counts.sides, 2u);
  EXPECT_EQ(counts.textures + counts.references + counts.ldis, baked_->count());
}

TEST_F(ImagesTest, FromItsViewpointAnImageShowsWhatGeometryShows) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  for (std::size_t i = 0; i < front().texture_fan.size(); ++i) {
    const Camera camera = cameraAt(front().texture_fan.viewpoints()[i]);
    const Image truth = painted(painter, Method::kGeometry, camera);
    EXPECT_GT(psnr(painted(painter, Method::kTexture, camera), truth), 28) << i;
  }
  for (std::size_t i = 0; i < front().reference_fan.size(); ++i) {
    const Camera camera = cameraAt(front().reference_fan.viewpoints()[i]);
    const Image truth = painted(painter, Method::kGeometry, camera);
    const double warped = psnr(painted(painter, Method::kWarp, camera), truth);
    EXPECT_GT(warped, 28) << i;
    // Between its viewpoints a texture does not move as the room does.
    if (i == 0 || i + 1 == front().reference_fan.size()) continue;
    EXPECT_LT(psnr(painted(painter, Method::kTexture, camera), truth), warped) << i;
  }
}

TEST_F(ImagesTest, ATextureShowsOnlyWithinItsPortal) {
  // The same doorway cut to a triangle, and its textures in a colour that nothing else has.
  House cut = *house_;
  Portal& portal = cut.graph.portals[0];
  portal.polygon.resize(3);
  PortalImages images = *baked_;
  for (Image& texture : images.side(0, true).textures) {
    for (std::size_t i = 0; i < texture.rgba.size(); ++i) texture.rgba[i] = i % 4 == 1 ? 0 : 255;
  }
  FramePainter painter(*gl_, cut, images, kWidth, kHeight, 1);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[2]);
  const Image picture = painted(painter, Method::kTexture, camera);

  const PlanarCamera planar = planarCamera(camera, kWidth, kHeight);
  std::vector<glm::vec2> outline;
  for (const glm::vec3& corner : grownPolygon(portal.polygon, portal.plane, 0.03f)) {
    outline.emplace_back(projectPoint(planar, glm::dvec3(corner)));
  }
  std::vector<glm::ivec2> spans(kHeight, glm::ivec2(0));
  fillConvexPolygon(outline, kWidth, kHeight, spans);
  int within = 0, shown = 0;
  for (int y = 0; y < kHeight; ++y) {
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    within += span.y - span.x;
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t* rgba = &picture.rgba[4 * static_cast<std::size_t>(y * kWidth + x)];
      const bool texture = rgba[0] == 255 && rgba[1] == 0 && rgba[2] == 255;
      shown += texture;
      EXPECT_TRUE(!texture || (x >= span.x && x < span.y)) << x << ", " << y;
    }
  }
  EXPECT_GT(within, 1000);
  EXPECT_GT(shown, within * 8 / 10);
}

TEST_F(ImagesTest, ClippingChangesNoPixelAndSplatsAndFillingDo) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 2);
  Camera camera = cameraAt(front().reference_fan.viewpoints()[2] + glm::dvec3(0.3, 0.1, 0));
  camera.vertical_fov = 0.5f;  // so near that single pixels leave gaps
  const auto paintedBy = [&](const WarpingNames& names) {
    painter.setWarping(parseWarping(names));
    return painted(painter, Method::kWarp, camera);
  };
  const Image usual = paintedBy({});
  EXPECT_EQ(paintedBy({.clip = "none"}).rgba, usual.rgba);
  EXPECT_EQ(paintedBy({.clip = "columns"}).rgba, usual.rgba);
  const Image pierced = paintedBy({.splat = "1x1"});
  EXPECT_NE(pierced.rgba, usual.rgba);
  EXPECT_NE(paintedBy({.splat = "1x1", .holes = "inpaint"}).rgba, pierced.rgba);
}

TEST_F(ImagesTest, HolesAreCountedTheSameHoweverTheyAreFilled) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  Camera camera = cameraAt(front().reference_fan.viewpoints()[2] + glm::dvec3(0.3, 0.1, 0));
  camera.vertical_fov = 0.5f;  // so near that single pixels leave gaps
  std::vector<double> uncovered;
  for (const char* holes : {"none", "inpaint", "persist"}) {
    painter.setWarping(parseWarping({.splat = "1x1", .holes = holes}));
    painter.paint(Method::kWarp, camera);
    PortalMask mask;
    painter.readPortalMask(mask);
    uncovered.push_back(painter.uncoveredPercent(mask));
  }
  EXPECT_GT(uncovered[0], 0.1);
  EXPECT_EQ(uncovered[1], uncovered[0]);
  EXPECT_EQ(uncovered[2], uncovered[0]);
}

TEST_F(ImagesTest, AMethodReportsWhatItsImagesCost) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[1]);
  for (const Method method : kImageMethods) {
    const FrameCost cost = painter.paint(method, camera);
    EXPECT_EQ(cost.portals_as_images, 1u);
    EXPECT_TRUE(cost.composite_ms && cost.uncovered_percent);
    EXPECT_FALSE(cost.capture_ms);
    EXPECT_EQ(cost.samples.has_value(), method != Method::kTexture);
    EXPECT_EQ(cost.warp_ms.has_value(), method != Method::kTexture);
  }
  const std::size_t one = *painter.paint(Method::kWarp, camera).samples;
  EXPECT_GT(*painter.paint(Method::kWarp2, camera).samples, one);
}

TEST_F(ImagesTest, OnDemandBecomesTheBakedPictureOneCaptureAFrame) {
  FramePainter baked(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  FramePainter painter(*gl_, *house_, {}, kWidth, kHeight, 1, ImageSource::kOnDemand);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[1] * 0.9 + 0.1 * glm::dvec3(2));
  const Image geometry = painted(baked, Method::kCulling, camera);
  for (const Method method : kImageMethods) {
    // The captures that it takes, and one frame more.
    const int frames = method == Method::kLdi ? 7 : infoOf(method).images_at_once;
    painter.prepare(method);
    Image picture = painted(painter, method, camera);
    if (method == Method::kLdi) {
      EXPECT_EQ(picture.rgba, geometry.rgba) << "until the image is there";
    }
    for (int i = 1; i < frames; ++i) picture = painted(painter, method, camera);
    EXPECT_EQ(picture.rgba, painted(baked, method, camera).rgba) << infoOf(method).name;
    EXPECT_LT(psnr(picture, geometry), 100) << infoOf(method).name;
    EXPECT_EQ(painted(painter, method, camera).rgba, picture.rgba);
  }
}

/// Walks to and fro before the doorway, in the first room.
std::vector<Camera> walkBeforeTheDoorway() {
  std::vector<Camera> walk;
  for (int i = 0; i < 60; ++i) {
    Camera camera;
    camera.far_plane = 100;
    camera.vertical_fov = 1.2f;
    const float z = 2.0f + 1.6f * std::sin(0.3f * static_cast<float>(i));
    camera.pose = lookAt({2.2f, 1.6f, z}, {4.1f, 1.2f, 2.0f});
    walk.push_back(camera);
  }
  return walk;
}

class ImageMakerTest : public ImagesTest {
 protected:
  VisibleSet seen(const Camera& camera) const {
    const View view = camera.view();
    return cullByPortals(house_->graph, view, locate(house_->graph, house_->grid, view.eye).cell);
  }

  ObjectIndex objects_{*house_};
  Renderer renderer_{*gl_, house_->building};
};

TEST_F(ImageMakerTest, MakesTheBakedImagesAtMostOneAFrame) {
  for (const Method method : kImageMethods) {
    ImageMaker maker(infoOf(method), *house_, objects_, renderer_);
    std::size_t made = 0;
    for (const Camera& camera : walkBeforeTheDoorway()) {
      const bool more = maker.makeOne(seen(camera), camera.pose.position);
      EXPECT_LE(maker.images().count(), made + (more ? 1 : 0));
      made = maker.images().count();
    }
    EXPECT_GT(made, method == Method::kLdi ? 0u : 2u) << infoOf(method).name;
    for (const bool from_front : {true, false}) {
      const SideImages& mine = maker.images().side(0, from_front);
      const SideImages& theirs = std::as_const(*baked_).side(0, from_front);
      for (std::size_t i = 0; i < mine.textures.size(); ++i) {
        if (!mine.hasTexture(i)) continue;
        EXPECT_EQ(mine.textures[i].rgba, theirs.textures[i].rgba);
      }
      const auto expectSame = [](const Ldi& a, const Ldi& b) {
        ASSERT_EQ(a.samples.size(), b.samples.size());
        EXPECT_EQ(std::memcmp(a.samples.data(), b.samples.data(), 8 * a.samples.size()), 0);
      };
      for (std::size_t i = 0; i < mine.references.size(); ++i) {
        if (!mine.hasReference(i)) continue;
        expectSame(mine.references[i], theirs.references[i]);
      }
      if (mine.has(ImageKind::kLdi)) expectSame(mine.ldi, theirs.ldi);
    }
  }
}

TEST_F(ImageMakerTest, NothingIsMadeForAPortalThatShowsGeometry) {
  ImageMaker maker(infoOf(Method::kTexture), *house_, objects_, renderer_);
  Camera near = walkBeforeTheDoorway().front();
  near.pose = lookAt({3.75f, 1.6f, 2.0f}, {4.1f, 1.2f, 2.0f});
  EXPECT_FALSE(maker.makeOne(seen(near), near.pose.position));
  EXPECT_EQ(maker.bytes(), 0u);
}

TEST_F(ImageMakerTest, WhatIsKeptIsBoundedAndTheSideSeenLastStays) {
  // Room for one side's textures, not for two.
  const std::size_t most = 4 * front().textures[0].rgba.size();
  ImageMaker maker(infoOf(Method::kTexture), *house_, objects_, renderer_, most);
  std::vector<Camera> walk = walkBeforeTheDoorway();
  for (Camera camera : walkBeforeTheDoorway()) {  // and in the other room
    camera.pose = lookAt({6.0f, 1.6f, camera.pose.position.z}, {4.1f, 1.2f, 2.0f});
    walk.push_back(camera);
  }
  for (const Camera& camera : walk) {
    maker.makeOne(seen(camera), camera.pose.position);
    EXPECT_LE(maker.bytes(), most);
    const bool in_first_room = camera.pose.position.x < 4.1f;
    const bool first_is_front = house_->graph.portals[0].front == 1;
    EXPECT_TRUE(maker.images().side(0, in_first_room == first_is_front).has(ImageKind::kTexture));
  }
  EXPECT_FALSE(maker.images().side(0, house_->graph.portals[0].front == 1).has(ImageKind::kTexture))
      << "the first room's should have given way";
  maker.forget();
  EXPECT_EQ(maker.bytes(), 0u);
  EXPECT_EQ(maker.images().count(), 0u);
}

TEST_F(ImagesTest, AResizedPainterPaintsWhatANewOneOfThatSizeDoes) {
  FramePainter grown(*gl_, *house_, *baked_, 40, 30, 1),
      fresh(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[1]);
  for (const Method method : kImageMethods) {
    grown.resize(40, 30);
    painted(grown, method, camera);
    grown.resize(kWidth, kHeight);
    EXPECT_EQ(painted(grown, method, camera).rgba, painted(fresh, method, camera).rgba)
        << infoOf(method).name;
  }
}

TEST_F(ImagesTest, AFrameChosenForItsOwnCameraIsThatFrame) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[1]);
  for (const MethodInfo& method : allMethods()) {
    const Image own = painted(painter, method.method, camera);
    painter.paint(method.method, camera, {.chosen_for = camera});
    Image chosen;
    painter.read(chosen);
    EXPECT_EQ(chosen.rgba, own.rgba) << method.name;
  }
}

TEST_F(ImagesTest, AFrozenFrameLacksWhatItsCameraDidNotSee) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  const Camera frozen = cameraAt(front().texture_fan.viewpoints()[1]);
  Camera back = frozen;
  back.pose = lookAt(frozen.pose.position, 2.0f * frozen.pose.position - glm::vec3(4.1f, 1.2f, 2));
  painter.paint(Method::kCulling, back, {.chosen_for = frozen});
  Image behind, truth;
  painter.read(behind);
  truth = painted(painter, Method::kGeometry, back);
  EXPECT_NE(behind.rgba, truth.rgba);
  // From behind its picture an image is not there.
  Camera beyond = frozen;
  beyond.pose = lookAt({8.2f - frozen.pose.position.x, 1.6f, 2.0f}, {4.1f, 1.2f, 2.0f});
  const FrameCost cost = painter.paint(Method::kLdi, beyond, {.chosen_for = frozen});
  EXPECT_EQ(cost.portals_as_images, 0u);
}

TEST_F(ImagesTest, WireframesShowLessThanSurfacesAndLeaveNoTrace) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[1]);
  const Image before = painted(painter, Method::kCulling, camera);
  painter.paint(Method::kCulling, camera, {.wireframe = true});
  Image wires;
  painter.read(wires);
  const auto skyPixels = [](const Image& picture) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      count += std::equal(kSkyColor, kSkyColor + 3, &picture.rgba[i]);
    }
    return count;
  };
  EXPECT_GT(skyPixels(wires), skyPixels(before) + 1000);
  EXPECT_LT(skyPixels(wires), std::size_t{kWidth} * kHeight - 100);
  EXPECT_EQ(painted(painter, Method::kCulling, camera).rgba, before.rgba);
}

TEST_F(ImagesTest, AStandInIsWarpedInPlaceOfTheImage) {
  FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  const Camera camera = cameraAt(front().texture_fan.viewpoints()[1]);
  Ldi red = front().ldi;
  for (LdiSample& sample : red.samples) sample.r = 255, sample.g = sample.b = 0;
  painter.setStandIn([&](const Ldi& image) { return &image == &front().ldi ? &red : &image; });
  const Image picture = painted(painter, Method::kLdi, camera);
  PortalMask mask;
  painter.readPortalMask(mask);
  std::vector<std::uint8_t> uncovered;
  painter.readUncovered(mask, uncovered);
  std::size_t reds = 0, pixels = 0;
  for (std::size_t p = 0; p < mask.of_pixel.size(); ++p) {
    if (mask.of_pixel[p] == 0 || uncovered[p]) continue;
    ++pixels;
    reds += picture.rgba[4 * p] == 255 && picture.rgba[4 * p + 1] == 0;
  }
  EXPECT_GT(pixels, 500u);
  EXPECT_EQ(reds, pixels);
  EXPECT_NEAR(painter.uncoveredPercent(mask),
              100.0 * static_cast<double>(std::count(uncovered.begin(), uncovered.end(), 1)) /
                  (kWidth * kHeight),
              1e-9);
}

}  // namespace
}  // namespace enfilade
