// Models of a sensible building at sizes and places that are not: the whole job either works and
// says what is odd, or refuses in one line and leaves nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "portals/house.h"
#include "tests/app/run_program.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

/// An OBJ of two closed rooms with a doorway between them, 8.2 m long and 3 m high, times `scale`
/// and moved by `offset` along x and z.
std::string twoRoomsObj(double scale, double offset) {
  constexpr double kBoxes[][6] = {
      {0, -0.2, 0, 8.2, 0, 4.2},   {0, 2.6, 0, 8.2, 2.8, 4.2},  // floor, ceiling
      {0, 0, 0, 0.2, 2.6, 4.2},    {8, 0, 0, 8.2, 2.6, 4.2},    // outer walls
      {0.2, 0, 0, 8, 2.6, 0.2},    {0.2, 0, 4, 8, 2.6, 4.2},    //
      {4, 0, 0.2, 4.2, 2.6, 1.5},  {4, 0, 2.5, 4.2, 2.6, 4},    // beside the doorway
      {4, 2.1, 1.5, 4.2, 2.6, 2.5}};                            // above it
  constexpr int kSides[][4] = {{1, 2, 4, 3}, {5, 7, 8, 6}, {1, 5, 6, 2},
                               {3, 4, 8, 7}, {1, 3, 7, 5}, {2, 6, 8, 4}};
  std::string vertices, faces;
  int first = 0;
  for (const auto& box : kBoxes) {
    for (int corner = 0; corner < 8; ++corner) {
      const double x = box[corner & 4 ? 3 : 0], y = box[corner & 2 ? 4 : 1],
                   z = box[corner & 1 ? 5 : 2];
      vertices += fmt::format("v {:.9g} {:.9g} {:.9g}\n", x * scale + offset, y * scale,
                              z * scale + offset);
    }
    for (const auto& side : kSides) {
      faces += fmt::format("f {} {} {} {}\n", first + side[0], first + side[1], first + side[2],
                           first + side[3]);
    }
    first += 8;
  }
  return vertices + faces;
}

class DegenerateModels : public ::testing::Test {
 protected:
  ProgramResult run(const std::vector<std::string>& arguments) const {
    return runEnfilade(arguments, here_.path());
  }

  ProgramResult preprocess(double scale, double offset) const {
    writeText(here_ / "model.obj", twoRoomsObj(scale, offset));
    return run(
        {"preprocess", "model.obj", "-o", "house", "--image-size", "32", "--captures", "ring:3"});
  }

  /// Expects a house, and that `note` is said of it.
  void expectNote(double scale, double offset, const std::string& note) const {
    const ProgramResult result = preprocess(scale, offset);
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_NE(result.errors.find(note), std::string::npos) << result.errors;
  }

  void expectRefusal(double scale, double offset, const std::string& reason) const {
    const ProgramResult result = preprocess(scale, offset);
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.errors.find(reason), std::string::npos) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(here_ / "house"));
  }

  /// Plays the house on a path that stands still at `eye`.
  void expectPlays(const glm::vec3& eye) const {
    writeText(here_ / "still.tum",
              fmt::format("0 {0} {1} {2} 0 0 0 1\n1 {0} {1} {2} 0 0 0 1\n", eye.x, eye.y, eye.z));
    const ProgramResult result = run({"play", "house", "--tour", "still.tum", "-o", "played",
                                      "--methods", "geometry,culling,ldi", "--size", "32x24"});
    EXPECT_EQ(result.status, 0) << result.errors;
  }

  TemporaryFolder here_;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(DegenerateModels, NoneIsASensibleOne) {
  const ProgramResult result = preprocess(1, 0);
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_FALSE(holds(result.errors, "note: ")) << result.errors;
  EXPECT_EQ(readHouse(here_ / "house").graph.portals.size(), 1u);
  expectPlays({2, 1.6, 2});
}

TEST_F(DegenerateModels, InKilometresIsTooSmallForRooms) {
  const ProgramResult result = preprocess(0.001, 0);
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(holds(result.errors, "only 0.0082 m long: is the model in metres?")) << result.errors;
  EXPECT_TRUE(holds(result.errors, "no room was found")) << result.errors;
  expectPlays({0.002f, 0.0016f, 0.002f});
  const ProgramResult tour = run({"tour", "house", "-o", "t.json"});
  EXPECT_EQ(tour.status, 2);
  EXPECT_TRUE(holds(tour.errors, "nowhere to stand")) << tour.errors;
  const ProgramResult inspect = run({"inspect", "house"});
  EXPECT_TRUE(holds(inspect.output, "no room was found")) << inspect.output;
}

TEST_F(DegenerateModels, ADollsHouseIsOneCell) {
  expectNote(0.3, 0, "no room was found");
  EXPECT_EQ(readHouse(here_ / "house").graph.cells.size(), 1u);
  expectPlays({0.6f, 0.4f, 0.6f});
}

TEST_F(DegenerateModels, InCentimetresIsTooLargeForTheVoxels) {
  expectRefusal(100, 0, "too large for voxels of 0.10 m; voxels of 0.61 m would do");
}

TEST_F(DegenerateModels, AHundredKilometresLongAsksForItsUnit) {
  expectRefusal(12'000, 0, "are its lengths in metres");
}

TEST_F(DegenerateModels, BeyondReckoning) {
  expectRefusal(1e29, 0, "holds no triangles: faces with a corner that is no number within 1e12 m");
}

TEST_F(DegenerateModels, AHundredKilometresOffWorksAndSaysHowCoarseItIs) {
  expectNote(1, 1e5, "100 km from the origin, where coordinates lie 7.8 mm apart");
  EXPECT_EQ(readHouse(here_ / "house").graph.portals.size(), 1u);
  expectPlays({100'002, 1.6f, 100'002});
}

TEST_F(DegenerateModels, SoFarOffThatNothingIsLeftOfItIsRefused) {
  expectRefusal(1, 1e6, "coordinates lie 62 mm apart, too coarse for voxels of 0.10 m");
  expectRefusal(1, 1e7, "coordinates lie 1.00 m apart, too coarse");
  expectRefusal(1, 1e12, "holds no triangles: faces without area");
}

}  // namespace
}  // namespace enfilade
