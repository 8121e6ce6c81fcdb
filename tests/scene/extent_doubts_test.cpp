#include "scene/extent_doubts.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

Box boxAt(float from, const glm::vec3& size) {
  return {{from, 0, from}, glm::vec3{from, 0, from} + size};
}

std::string onlyDoubt(const Box& bounds) {
  const std::vector<std::string> doubts = extentDoubts(bounds);
  EXPECT_EQ(doubts.size(), 1u);
  return doubts.empty() ? "" : doubts.front();
}

TEST(ExtentDoubts, AHouseHasNone) {
  EXPECT_TRUE(extentDoubts(boxAt(0, {12, 6, 9})).empty());
  EXPECT_TRUE(extentDoubts(boxAt(-20'000, {12, 6, 9})).empty());
  EXPECT_TRUE(extentDoubts({}).empty());
}

TEST(ExtentDoubts, LengthsInAnotherUnit) {
  EXPECT_EQ(onlyDoubt(boxAt(0, {12'000, 6000, 9000})), "12000 m long: is the model in metres?");
  EXPECT_EQ(onlyDoubt(boxAt(0, {0.012f, 0.006f, 0.009f})),
            "only 0.012 m long: is the model in metres?");
}

TEST(ExtentDoubts, AHouseOnItsSide) {
  EXPECT_NE(onlyDoubt(boxAt(0, {12, 40, 9})).find("+Y"), std::string::npos);
}

TEST(ExtentDoubts, AHouseInACountrysCoordinates) {
  EXPECT_EQ(onlyDoubt(boxAt(100'000, {12, 6, 9})),
            "100 km from the origin, where coordinates lie 7.8 mm apart: move it nearer");
  EXPECT_EQ(onlyDoubt(boxAt(-1e7f, {12, 6, 9})),
            "10000 km from the origin, where coordinates lie 1.00 m apart: move it nearer");
}

TEST(CoordinateStep, IsTheDistanceOfNeighbouringFloats) {
  EXPECT_EQ(coordinateStep({}), 0);
  EXPECT_EQ(coordinateStep({{-70'000, 0, 0}, {1, 1, 1}}), 0.0078125f);
  EXPECT_EQ(coordinateStep({{0, 0, 0}, {70'000, 1, 1}}), 0.0078125f);
}

TEST(LengthText, IsInTheUnitThatSuitsIt) {
  EXPECT_EQ(lengthText(0.0078125f), "7.8 mm");
  EXPECT_EQ(lengthText(0.05f), "50 mm");
  EXPECT_EQ(lengthText(0.1f), "0.10 m");
  EXPECT_EQ(lengthText(-2.456f), "-2.46 m");
  EXPECT_EQ(lengthText(98'400), "98 km");
}

}  // namespace
}  // namespace enfilade
