// The built program by EGL beside OSMesa.  Where a machine has no EGL this skips, and says why.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/image_quality.h"
#include "scene/error.h"
#include "scene/gltf_writer.h"
#include "scene/image.h"
#include "tests/app/run_program.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

TEST(EglPlay, KeepsTheFramesThatOsMesaKeepsUpToRounding) {
  const TemporaryFolder here;
  writeGlb(here / "model.glb", twoRoomHouse().building);
  const auto run = [&](const std::vector<std::string>& arguments) {
    return runEnfilade(arguments, here.path());
  };
  ASSERT_EQ(run({"preprocess", "model.glb", "-o", "house", "--image-size", "32", "--captures",
                 "ring:3", "--sight-lines", "5000", "-q"})
                .status,
            0);
  ASSERT_EQ(run({"tour", "house", "-o", "tour.json", "--frames", "8", "-q"}).status, 0);
  for (const std::string gl : {"osmesa", "egl"}) {
    const ProgramResult played =
        run({"play", "house", "--tour", "tour.json", "--methods", "culling,ldi", "--size",
             "160x128", "--frames-dir", gl, "--gl", gl, "-q", "-o", "report-" + gl});
    if (gl == "egl" && played.status == 3) {
      EXPECT_NE(played.errors.find("--gl osmesa"), std::string::npos);
      GTEST_SKIP() << played.errors;
    }
    ASSERT_EQ(played.status, 0) << played.errors;
  }
  EXPECT_NE(textOf(here / "report-egl/summary.json").find(" by EGL"), std::string::npos);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(here / "osmesa")) {
    if (!entry.is_regular_file()) continue;
    const std::string name = std::filesystem::relative(entry.path(), here / "osmesa").string();
    const Image expected = readImage(entry.path().string());
    const Image drawn = readImage(here / ("egl/" + name));
    EXPECT_GT(compareImages(drawn, expected).psnr_db, 40) << name;
  }
}

}  // namespace
}  // namespace enfilade
