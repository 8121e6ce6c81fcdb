// Walks up to a doorway that shows a flat magenta image of the room behind it.
#include "app/quality_pass.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/frame_files.h"
#include "ibr/ldi_file.h"
#include "ibr/portal_capture.h"
#include "scene/file_io.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 80;
constexpr PortalSide kDoorway{0, false};  ///< as the left room sees it, at x = 4.1

/// A capture that is magenta, with nothing in its rows from `rows` on (a share of them).
DepthImage magentaCapture(const PlanarCamera& camera, double rows) {
  DepthImage image{camera, {camera.width, camera.height, {}}, {}};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      for (const int v : {255, 0, 255, 255})
        image.color.rgba.push_back(static_cast<std::uint8_t>(v));
      image.disparity.push_back(y < rows * camera.height ? 0.9f : 0.0f);
    }
  }
  return image;
}

bool isMagenta(const Image& image, std::size_t pixel) {
  const std::uint8_t* const p = &image.rgba[4 * pixel];
  return p[0] > 240 && p[1] < 15 && p[2] > 240;
}

class QualityPass : public ::testing::Test {
 protected:
  QualityPass() : house_(twoRoomHouse()), gl_(createOsMesaContext(1)) {
    useImage(1.0);
    for (int i = 0; i < 8; ++i)
      path_.poses.push_back({0.1 * i, poseAt(1.0f + 0.3f * static_cast<float>(i))});
  }

  /// Looks at the doorway from the left room.
  static Pose poseAt(float x) { return lookAt({x, 1.5f, 1.8f}, {4.1f, 1.3f, 2.0f}); }

  void useImage(double rows) {
    ImageParameters parameters;
    parameters.image_size = 64;
    parameters.rings = {{5, 75.0f, 0.0f}, {6, 62.5f, -0.5f}};
    const Ldi ldi =
        buildLdi(house_.graph.portals[kDoorway.portal], kDoorway.from_front, 1.6f, parameters,
                 [&](const PlanarCamera& c) { return magentaCapture(c, rows); });
    const std::string folder =
        portalImageFolder(here_.path(), kDoorway.portal, kDoorway.from_front);
    createFolders(folder);
    writeLdi(folder + "/ldi.bin", ldi);
    house_.files[portalImageName(kDoorway.portal, kDoorway.from_front, "ldi.bin")] =
        fileChecksum(readFile(folder + "/ldi.bin"));
    painter_.reset();
    images_ = PortalImages(house_, here_.path());
    painter_ = std::make_unique<FramePainter>(*gl_, house_, images_, kWidth, kHeight, 1);
    camera_ = walkingCamera(house_, 1.2f, kWidth, kHeight);
  }

  Image paint(Method method, float x) {
    camera_.pose = poseAt(x);
    painter_->paint(method, camera_);
    Image picture;
    painter_->read(picture);
    return picture;
  }

  PictureFindings look(const PicturePass& pass) {
    records_.clear();
    for (const Method method : pass.methods) {
      for (std::size_t f = 0; f < path_.poses.size(); ++f) records_.push_back({method, f, {}});
    }
    return lookAtFrames(*painter_, Walk(path_, camera_), pass, {}, records_);
  }

  const FrameRecord& record(std::size_t method, std::size_t frame) const {
    return records_[method * path_.poses.size() + frame];
  }

  /// Whether the doorway shows its image in that frame of the path.
  bool imageIn(std::size_t frame) const {
    return 4.1f - path_.poses[frame].pose.position.x > house_.switch_distance;
  }

  TemporaryFolder here_;
  House house_;
  std::unique_ptr<GlContext> gl_;
  PortalImages images_;
  std::unique_ptr<FramePainter> painter_;
  Camera camera_;
  CameraPath path_;
  std::vector<FrameRecord> records_;
};

TEST_F(QualityPass, TheMaskIsThePixelsThatShowTheImage) {
  const Image picture = paint(Method::kLdi, 1.0f);
  PortalMask mask;
  painter_->readPortalMask(mask);
  ASSERT_EQ(mask.sides, std::vector<PortalSide>{kDoorway});
  ASSERT_EQ(mask.of_pixel.size(), static_cast<std::size_t>(kWidth * kHeight));
  int marked = 0;
  for (std::size_t i = 0; i < mask.of_pixel.size(); ++i) {
    EXPECT_EQ(mask.of_pixel[i] != 0, isMagenta(picture, i)) << i % kWidth << ", " << i / kWidth;
    marked += mask.of_pixel[i];
  }
  EXPECT_GT(marked, 300);
}

TEST_F(QualityPass, TheMaskHoldsWhatTheImageLeavesUncovered) {
  paint(Method::kLdi, 1.0f);
  PortalMask whole, holed;
  painter_->readPortalMask(whole);
  useImage(0.5);
  const Image picture = paint(Method::kLdi, 1.0f);
  painter_->readPortalMask(holed);
  EXPECT_EQ(holed.of_pixel, whole.of_pixel);
  int uncovered = 0;
  for (std::size_t i = 0; i < holed.of_pixel.size(); ++i) {
    uncovered += holed.of_pixel[i] != 0 && !isMagenta(picture, i);
  }
  EXPECT_GT(uncovered, 100);
}

TEST_F(QualityPass, AFrameWithoutImagesHasNoMask) {
  PortalMask mask;
  paint(Method::kCulling, 1.0f);
  painter_->readPortalMask(mask);
  EXPECT_TRUE(mask.sides.empty() && mask.of_pixel.empty());
  paint(Method::kLdi, 3.0f);
  painter_->readPortalMask(mask);
  EXPECT_TRUE(mask.sides.empty() && mask.of_pixel.empty());
}

TEST_F(QualityPass, APortalThatIsToShowGeometryDoesSo) {
  const Image culled = paint(Method::kCulling, 1.0f);
  EXPECT_NE(paint(Method::kLdi, 1.0f).rgba, culled.rgba);
  painter_->paint(Method::kLdi, camera_, {kDoorway});
  Image picture;
  painter_->read(picture);
  EXPECT_EQ(picture.rgba, culled.rgba);
}

TEST_F(QualityPass, OnlyFramesThatShowImagesHaveQualityInPortals) {
  look({{Method::kGeometry, Method::kLdi}, true, ""});
  for (std::size_t frame = 0; frame < path_.poses.size(); ++frame) {
    EXPECT_FALSE(record(0, frame).quality->psnr_portals_db);
    const ImageQuality& quality = record(1, frame).quality.value();
    EXPECT_EQ(quality.psnr_portals_db.has_value(), imageIn(frame)) << frame;
    EXPECT_EQ(quality.ssim_portals.has_value(), imageIn(frame)) << frame;
    // All that is wrong is in the doorway.
    EXPECT_LT(quality.psnr_portals_db.value_or(0), quality.psnr_db - 3);
    EXPECT_EQ(quality.psnr_db == kIdenticalPsnr, !imageIn(frame));
  }
}

TEST_F(QualityPass, QualityInPortalsIsThatOfTheMasksPixels) {
  look({{Method::kLdi}, true, ""});
  const Image picture = paint(Method::kLdi, 1.0f);
  PortalMask mask;
  painter_->readPortalMask(mask);
  const Image truth = paint(Method::kGeometry, 1.0f);
  double squares = 0, values = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 == 3 || mask.of_pixel[i / 4] == 0) continue;
    squares += (picture.rgba[i] - truth.rgba[i]) * (picture.rgba[i] - truth.rgba[i]);
    ++values;
  }
  const double right = 10 * std::log10(255.0 * 255.0 * values / squares);
  EXPECT_NEAR(record(0, 0).quality->psnr_portals_db.value(), right, 1e-9);
}

TEST_F(QualityPass, FlickerStandsOutAtTheSwitchAndIsNoneByGeometry) {
  look({{Method::kGeometry, Method::kCulling, Method::kLdi}, true, ""});
  double greatest = 0;
  std::size_t at = 0;
  for (std::size_t frame = 1; frame < path_.poses.size(); ++frame) {
    EXPECT_EQ(record(0, frame).flicker, 0.0);
    EXPECT_EQ(record(1, frame).flicker, 0.0);
    if (record(2, frame).flicker.value() > greatest) {
      greatest = *record(2, frame).flicker;
      at = frame;
    }
  }
  EXPECT_FALSE(record(2, 0).flicker);
  EXPECT_TRUE(imageIn(at - 1) && !imageIn(at)) << at;
}

TEST_F(QualityPass, AJumpIsTheDifferenceOfImageAndGeometryAtOnePose) {
  const PictureFindings there = look({{Method::kCulling, Method::kLdi}, true, ""});
  ASSERT_EQ(there.jumps.size(), 1u);
  const SwitchJump& jump = there.jumps.front();
  EXPECT_EQ(jump.method, Method::kLdi);
  EXPECT_EQ(jump.event, (PortalSwitch{kDoorway, true}));
  EXPECT_TRUE(imageIn(jump.frame) && !imageIn(jump.frame + 1));
  const float x = path_.poses[jump.frame].pose.position.x;
  const Image geometry = paint(Method::kGeometry, x), image = paint(Method::kLdi, x);
  PortalMask mask;
  painter_->readPortalMask(mask);
  double sum = 0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < mask.of_pixel.size(); ++i) {
    if (mask.of_pixel[i] == 0) continue;
    ++pixels;
    for (std::size_t k = 4 * i; k < 4 * i + 3; ++k)
      sum += std::abs(geometry.rgba[k] - image.rgba[k]);
  }
  EXPECT_EQ(jump.pixels, pixels);
  EXPECT_NEAR(jump.levels, sum / (3.0 * static_cast<double>(pixels)), 1e-9);

  // And the same on the way back.
  std::reverse(path_.poses.begin(), path_.poses.end());
  const PictureFindings back = look({{Method::kLdi}, true, ""});
  ASSERT_EQ(back.jumps.size(), 1u);
  EXPECT_EQ(back.jumps.front().event, (PortalSwitch{kDoorway, false}));
  EXPECT_EQ(back.jumps.front().frame, path_.poses.size() - 1 - jump.frame);
  EXPECT_EQ(back.jumps.front().levels, jump.levels);
}

TEST_F(QualityPass, TheSheetShowsTheWorstFrameFirst) {
  const PictureFindings findings = look({{Method::kCulling, Method::kLdi}, true, ""});
  ASSERT_TRUE(findings.sheet);
  const ContactSheet& sheet = *findings.sheet;
  EXPECT_EQ(sheet.methods, (std::vector<Method>{Method::kGeometry, Method::kLdi}));
  EXPECT_EQ(sheet.cell, glm::ivec2(kWidth, kHeight));
  ASSERT_EQ(sheet.rows.size(), 4u);
  EXPECT_EQ(sheet.picture.width, 3 * kWidth + 2 * kSheetGap);
  EXPECT_EQ(sheet.picture.height, 4 * kHeight + 3 * kSheetGap);
  double last = 0;
  for (const ContactSheet::Row& row : sheet.rows) {
    EXPECT_EQ(row.psnr_db.at(0), kIdenticalPsnr);
    EXPECT_EQ(row.psnr_db.at(1), record(1, row.frame).quality->psnr_db);
    EXPECT_GE(row.psnr_db.at(1), last);
    last = row.psnr_db.at(1);
  }
  for (std::size_t f = 0; f < path_.poses.size(); ++f) {
    EXPECT_GE(record(1, f).quality->psnr_db, sheet.rows[0].psnr_db[1]);
  }
}

TEST_F(QualityPass, WithoutAMethodThatShowsImagesThereIsNoSheet) {
  const PictureFindings findings = look({{Method::kGeometry, Method::kCulling}, true, ""});
  EXPECT_FALSE(findings.sheet);
  EXPECT_TRUE(findings.jumps.empty());
}

TEST_F(QualityPass, WithoutQualityOnlyTheFramesOfWhichPicturesAreKeptArePainted) {
  PicturePass pass{{Method::kCulling}, false, ""};
  pass.keeper = PictureKeeper(here_.path() + "/pictures", path_.poses.size(), 3);
  pass.keeper.begin(pass.methods);
  EXPECT_FALSE(pass.everyFrame());
  look(pass);
  EXPECT_TRUE(std::filesystem::exists(here_ / "pictures/culling/00006.jpg"));
  EXPECT_FALSE(std::filesystem::exists(here_ / "pictures/culling/00007.jpg"));
  pass.in_order = true;
  EXPECT_TRUE(pass.everyFrame());
}

TEST_F(QualityPass, WithoutQualityFramesAreKeptAndNothingElse) {
  createFolders(here_ / "culling");
  const PictureFindings findings = look({{Method::kCulling}, false, here_.path()});
  EXPECT_FALSE(findings.sheet || record(0, 1).quality || record(0, 1).flicker);
  EXPECT_EQ(readImage(here_ / frameFile(Method::kCulling, 7)).rgba,
            paint(Method::kCulling, path_.poses[7].pose.position.x).rgba);
}

}  // namespace
}  // namespace enfilade
