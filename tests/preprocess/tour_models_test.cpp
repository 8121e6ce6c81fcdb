#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "model_house.h"
#include "models/samples.h"
#include "preprocess/tour.h"
#include "preprocess/tour_check.h"
#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"

namespace enfilade {
namespace {

using testing::houseOf;

void expectWhole(const House& house, const Tour& tour, std::size_t frames) {
  EXPECT_EQ(tour.path.poses.size(), frames);
  EXPECT_EQ(tour.visited.size(), house.graph.cells.size());
  for (const TourViolation& v : checkTour(house, tour.path, 0.2f)) {
    ADD_FAILURE() << "pose " << v.pose << ": " << v.what;
  }
}

TEST(TourModels, VisitsEveryRoomOfTheGalleryAndTheParkOutside) {
  const std::string file = ::testing::TempDir() + "enfilade-tour-gallery.glb";
  writeGlb(file, raiseSample("gallery", 50'000));
  const House house = houseOf(readGltf(file), "", "");
  std::filesystem::remove(file);
  ASSERT_GE(house.graph.cells.size(), 10u);
  expectWhole(house, makeTour(house, {.frames = 520}), 520);
}

TEST(TourModels, VisitsBothFlatsOfTheDuplex) {
  const std::string file = ENFILADE_SOURCE_DIR "/../shared/models/duplex.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the shared models are not here";
  const House house = houseOf(readGltf(file), "IfcDoor*", "IfcWindow*");
  ASSERT_GE(house.graph.cells.size(), 12u);
  expectWhole(house, makeTour(house, {.frames = 520}), 520);
  expectWhole(house, makeTour(house, {.frames = 100}), 100);
}

}  // namespace
}  // namespace enfilade
