#include "ibr/capture_plan.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace enfilade {
namespace {

TEST(CapturePlan, IsThePapersOneRing) {
  const auto rings = parseCapturePlan("ring:13");
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].captures, 13);
  EXPECT_EQ(rings[0].above_eye, 0.0f);
  EXPECT_EQ(rings[0].angle, CaptureRing{}.angle);
}

TEST(CapturePlan, GivesEachRingItsHeightAndAngle) {
  const auto rings = parseCapturePlan("ring:9,ring:4@-0.5/62.5,ring:3@0.25,ring:1/0");
  ASSERT_EQ(rings.size(), 4u);
  EXPECT_EQ(rings[1].captures, 4);
  EXPECT_EQ(rings[1].above_eye, -0.5f);
  EXPECT_EQ(rings[1].angle, 62.5f);
  EXPECT_EQ(rings[2].above_eye, 0.25f);
  EXPECT_EQ(rings[2].angle, CaptureRing{}.angle);
  EXPECT_EQ(rings[3].angle, 0.0f);
}

TEST(CapturePlan, ReadsWhatItWrites) {
  for (const char* plan : {"ring:13", "ring:13,ring:6@-0.5/62.5", "ring:180@3/85", "ring:1/0"}) {
    EXPECT_EQ(capturePlanText(parseCapturePlan(plan)), plan);
  }
  const ImageParameters usual;
  const auto again = parseCapturePlan(capturePlanText(usual.rings));
  ASSERT_EQ(again.size(), usual.rings.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].captures, usual.rings[i].captures);
    EXPECT_EQ(again[i].angle, usual.rings[i].angle);
    EXPECT_EQ(again[i].above_eye, usual.rings[i].above_eye);
  }
}

TEST(CapturePlan, RefusesWhatItCannotRead) {
  const auto reason = [](const std::string& plan) -> std::string {
    try {
      parseCapturePlan(plan);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      return error.what();
    }
    return "taken";
  };
  const std::vector<std::pair<const char*, const char*>> wrong = {
      {"", "'' is no ring"},
      {"13", "'13' is no ring"},
      {"ring:", "the count must be 1 to 180"},
      {"ring:0", "the count must be 1 to 180"},
      {"ring:181", "the count must be 1 to 180"},
      {"ring:99999999999", "the count must be 1 to 180"},
      {"ring:13,", "'' is no ring"},
      {"ring:13 ,ring:6", "' ' in 'ring:13 '"},
      {"ring:6@low", "the height must be -3 to 3 m"},
      {"ring:6@-4", "the height must be -3 to 3 m"},
      {"ring:6@nan", "the height must be -3 to 3 m"},
      {"ring:6/90", "the angle must be 0 to 85 degrees"},
      {"ring:6/62@1", "'@1' in 'ring:6/62@1'"}};
  for (const auto& [plan, expected] : wrong) {
    const std::string said = reason(plan);
    EXPECT_TRUE(said.starts_with("--captures " + std::string(plan) + ": ")) << said;
    EXPECT_NE(said.find(expected), std::string::npos) << plan << ": " << said;
    EXPECT_NE(said.find("ring:13,ring:6@-0.5/62.5"), std::string::npos) << said;
  }
  std::string many = "ring:1";
  for (int i = 0; i < 16; ++i) many += ",ring:1";
  EXPECT_NE(reason(many).find("17 rings are too many"), std::string::npos);
}

}  // namespace
}  // namespace enfilade
