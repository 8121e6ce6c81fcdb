#include "app/frame_painter.h"

#include <gtest/gtest.h>

#include "app/playback.h"
#include "preprocess/tour.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 80;

/// Two rooms with a doorway and a walk through both.
class FramePainterTest : public ::testing::Test {
 protected:
  FramePainterTest()
      : house_(twoRoomHouse()),
        gl_(createOsMesaContext(1)),
        painter_(*gl_, house_, images_, kWidth, kHeight, 1),
        camera_(walkingCamera(house_, 1.0f, kWidth, kHeight)),
        path_(makeTour(house_, {.frames = 40}).path) {}

  Image paint(Method method, const Pose& pose) {
    camera_.pose = pose;
    cost_ = painter_.paint(method, camera_);
    Image picture;
    painter_.read(picture);
    return picture;
  }

  House house_;
  PortalImages images_;
  std::unique_ptr<GlContext> gl_;
  FramePainter painter_;
  Camera camera_;
  CameraPath path_;
  FrameCost cost_;
};

TEST_F(FramePainterTest, CullingIsThePictureOfGeometryAllAlongTheWalk) {
  std::size_t all = 0, drawn = 0;
  for (const TimedPose& timed : path_.poses) {
    const Image truth = paint(Method::kGeometry, timed.pose);
    all += cost_.triangles.value();
    const Image picture = paint(Method::kCulling, timed.pose);
    drawn += cost_.triangles.value();
    EXPECT_EQ(picture.rgba, truth.rgba) << "at " << timed.time << " s";
  }
  EXPECT_LE(drawn, all);
}

TEST_F(FramePainterTest, RaysShowNearlyTheSamePicture) {
  double worst = 100;
  for (std::size_t i = 0; i < path_.poses.size(); i += 8) {
    const Image truth = paint(Method::kGeometry, path_.poses[i].pose);
    worst = std::min(worst, psnr(paint(Method::kRaycast, path_.poses[i].pose), truth));
  }
  EXPECT_GT(worst, 30);
}

TEST_F(FramePainterTest, AMethodReportsWhatItHasAndNothingElse) {
  const Pose& pose = path_.poses.front().pose;
  paint(Method::kGeometry, pose);
  EXPECT_GT(cost_.frametime_ms, 0);
  EXPECT_TRUE(cost_.cull_ms && cost_.draw_ms && cost_.triangles);
  EXPECT_FALSE(cost_.cells || cost_.warp_ms || cost_.composite_ms || cost_.uncovered_percent);
  paint(Method::kRaycast, pose);
  EXPECT_TRUE(cost_.draw_ms);
  EXPECT_FALSE(cost_.cull_ms || cost_.triangles);
  paint(Method::kCulling, pose);
  EXPECT_TRUE(cost_.cells && cost_.portals);
  EXPECT_FALSE(cost_.warp_ms || cost_.portals_as_images);
  EXPECT_LE(*cost_.cull_ms + *cost_.draw_ms, cost_.frametime_ms + 1e-6);
}

TEST_F(FramePainterTest, WithoutImagesTheImageMethodIsCulling) {
  for (std::size_t i = 0; i < path_.poses.size(); i += 8) {
    const Image culled = paint(Method::kCulling, path_.poses[i].pose);
    EXPECT_EQ(paint(Method::kLdi, path_.poses[i].pose).rgba, culled.rgba);
    EXPECT_EQ(cost_.portals_as_images, 0u);
    EXPECT_EQ(cost_.uncovered_percent, 0.0);
  }
}

TEST_F(FramePainterTest, PlaybackRecordsEveryFrameOfEveryMethodAndKeepsPictures) {
  TemporaryFolder here;
  path_.poses.resize(5);
  std::vector<std::string> stages;
  const std::vector<FrameRecord> records =
      playBack(painter_, Walk(path_, camera_),
               {.methods = {Method::kGeometry, Method::kCulling},
                .quality = true,
                .frames_dir = here.path()},
               [&](const std::string& stage, double) {
                 if (stages.empty() || stages.back() != stage) stages.push_back(stage);
               })
          .records;
  ASSERT_EQ(records.size(), 10u);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].method, i < 5 ? Method::kGeometry : Method::kCulling);
    EXPECT_EQ(records[i].frame, i % 5);
    EXPECT_EQ(records[i].quality.value().psnr_db, 100);
    const Image kept = readImage(here / frameFile(records[i].method, records[i].frame));
    EXPECT_EQ(kept.rgba, paint(records[i].method, path_.poses[i % 5].pose).rgba);
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"playing by geometry", "playing by culling",
                                              "comparing pictures"}));
}

}  // namespace
}  // namespace enfilade
