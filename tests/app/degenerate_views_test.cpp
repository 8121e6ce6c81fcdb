// Views that no tour has: the picture of `culling` is that of `geometry` from everywhere, whatever
// the size of the frame, and does not depend on the frame before.

#include <gtest/gtest.h>

#include "app/frame_painter.h"
#include "models/samples.h"
#include "preprocess/preprocess.h"
#include "scene/gltf_writer.h"
#include "tests/app/random_views.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

using testing::EyePlace;
using testing::RandomView;
using testing::RandomViews;

/// The gallery, of few triangles.
House galleryHouse() {
  TemporaryFolder here;
  writeGlb(here / "gallery.glb", raiseSample("gallery", 50'000));
  PreprocessParameters parameters;
  parameters.images = false;
  return preprocessBuilding(here / "gallery.glb", here / "house", parameters).house;
}

/// Paints a house without images by geometry and by culling.
class Pictures {
 public:
  explicit Pictures(House& house)
      : gl_(createOsMesaContext(2)), painter_(*gl_, house, no_images_, 64, 64, 2) {}

  void resize(const glm::ivec2& size) { painter_.resize(size.x, size.y); }
  const Image& paint(Method method, const Camera& camera) {
    painter_.paint(method, camera);
    painter_.read(picture_);
    return picture_;
  }
  std::size_t differing(const Camera& camera) {
    const Image whole = paint(Method::kGeometry, camera);
    const Image& culled = paint(Method::kCulling, camera);
    std::size_t count = whole.rgba.size() == culled.rgba.size() ? 0 : 1;
    for (std::size_t i = 0; i < whole.rgba.size(); i += 4) {
      count += !std::equal(&whole.rgba[i], &whole.rgba[i] + 4, &culled.rgba[i]);
    }
    return count;
  }
  std::size_t cellsSeen() const { return painter_.visibleSet().cells.size(); }

 private:
  PortalImages no_images_;
  std::unique_ptr<GlContext> gl_;
  FramePainter painter_;
  Image picture_;
};

float aspectOf(const glm::ivec2& size) {
  return static_cast<float>(size.x) / static_cast<float>(size.y);
}

TEST(DegenerateViews, CullingIsThePictureOfGeometryFromEverywhere) {
  House house = galleryHouse();
  Pictures pictures(house);
  RandomViews random(house, 1);
  std::size_t culled = 0;
  for (const glm::ivec2 size : {glm::ivec2{160, 128}, {161, 127}, {97, 331}, {1, 1}, {3, 200}}) {
    pictures.resize(size);
    for (int i = 0; i < 80; ++i) {
      const RandomView view = random.next(aspectOf(size));
      const glm::vec3& eye = view.camera.pose.position;
      EXPECT_EQ(pictures.differing(view.camera), 0u)
          << nameOf(view.place) << ", (" << eye.x << ", " << eye.y << ", " << eye.z << "), "
          << glm::degrees(view.camera.vertical_fov) << " degrees, " << size.x << " x " << size.y;
      culled += pictures.cellsSeen() < house.graph.cells.size();
    }
  }
  EXPECT_GT(culled, 100u) << "most views see every cell: nothing was tested";
}

TEST(DegenerateViews, FramesMayBeOfAnySizeThatOpenGlTakes) {
  House house = twoRoomHouse();
  Pictures pictures(house);
  RandomViews random(house, 2);
  for (const glm::ivec2 size :
       {glm::ivec2{1, 1}, {1, 8192}, {8192, 1}, {8191, 3}, {7, 1023}, {8192, 8192}, {2, 2}}) {
    pictures.resize(size);
    const RandomView view = random.next(EyePlace::kFreeSpace, aspectOf(size));
    EXPECT_EQ(pictures.differing(view.camera), 0u) << size.x << " x " << size.y;
  }
}

TEST(DegenerateViews, AFrameDoesNotDependOnTheOneBeforeHoweverFarThePathJumps) {
  House house = twoRoomHouse();
  Pictures pictures(house);
  RandomViews random(house, 3);
  std::vector<Camera> cameras;
  std::vector<Image> first;
  for (int i = 0; i < 24; ++i) {
    cameras.push_back(random.next(1).camera);
    first.push_back(pictures.paint(Method::kCulling, cameras.back()));
  }
  for (std::size_t i = cameras.size(); i-- > 0;) {
    EXPECT_EQ(pictures.paint(Method::kCulling, cameras[i]).rgba, first[i].rgba) << "frame " << i;
  }
}

TEST(DegenerateViews, InsideAWallNothingIsCulled) {
  House house = twoRoomHouse();
  Pictures pictures(house);
  RandomViews random(house, 4);
  for (int i = 0; i < 10; ++i) {
    pictures.paint(Method::kCulling, random.next(EyePlace::kSolid, 1).camera);
    EXPECT_EQ(pictures.cellsSeen(), house.graph.cells.size());
  }
}

}  // namespace
}  // namespace enfilade
