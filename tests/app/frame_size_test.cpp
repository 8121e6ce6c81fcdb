#include "app/frame_size.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace enfilade {
namespace {

TEST(FrameSize, IsTwoNumbersAndNothingElse) {
  EXPECT_EQ(parseFrameSize("640x512"), glm::ivec2(640, 512));
  EXPECT_EQ(parseFrameSize("16x16384"), glm::ivec2(16, 16384));
  for (const char* bad :
       {"", "640", "x", "640x", "x512", "15x512", "640x16385", "640x512x", "+64x64", " 64x64",
        "64x 64", "64X64", "64.0x64", "-64x64", "4294967312x16", "99999999999999999999x64"}) {
    EXPECT_THROW(parseFrameSize(bad), Error) << bad;
  }
}

}  // namespace
}  // namespace enfilade
