#include "app/portal_mask.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(PortalMask, OnePortalsPixelsAreThoseWithItsNumber) {
  const PortalMask mask{{{7, true}, {9, false}}, {0, 1, 2, 2, 0}};
  EXPECT_EQ(pixelsOf(mask, 0), (std::vector<std::uint8_t>{0, 1, 0, 0, 0}));
  EXPECT_EQ(pixelsOf(mask, 1), (std::vector<std::uint8_t>{0, 0, 1, 1, 0}));
}

TEST(PortalSwitches, AreSidesThatBothFramesSeeInAnotherWay) {
  const std::vector<SeenPortal> before = {
      {{1, true}, true}, {{2, true}, false}, {{3, false}, true}, {{4, true}, true}};
  const std::vector<SeenPortal> after = {
      {{1, true}, false}, {{2, true}, true}, {{3, true}, false}, {{5, true}, true}};
  EXPECT_EQ(switchesBetween(before, after),
            (std::vector<PortalSwitch>{{{1, true}, true}, {{2, true}, false}}));
  EXPECT_TRUE(switchesBetween(before, before).empty());
}

}  // namespace
}  // namespace enfilade
