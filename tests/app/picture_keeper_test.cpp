#include "app/picture_keeper.h"

#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

/// Left half black, right half white.
Image halves(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto level = static_cast<std::uint8_t>(2 * x < width ? 0 : 255);
      image.rgba.insert(image.rgba.end(), {level, level, level, 255});
    }
  }
  return image;
}

std::size_t keptOf(const PictureKeeper& keeper, std::size_t frames) {
  std::size_t kept = 0;
  for (std::size_t frame = 0; frame < frames; ++frame) kept += keeper.keeps(frame);
  return kept;
}

TEST(PictureKeeper, KeepsTheFirstFrameAndNeverMoreThanWereAskedFor) {
  for (const std::size_t frames : {1u, 2u, 129u, 130u, 131u, 520u, 5201u}) {
    for (const std::size_t most : {1u, 7u, 130u, 1000u}) {
      const PictureKeeper keeper("", frames, most);
      EXPECT_TRUE(keeper.keeps(0));
      EXPECT_LE(keptOf(keeper, frames), most) << frames;
      EXPECT_GE(2 * keptOf(keeper, frames), std::min(frames, most)) << frames << " " << most;
    }
  }
}

TEST(PictureKeeper, OfNoneAskedForKeepsNoneAndMakesNoFolder) {
  const TemporaryFolder here;
  const PictureKeeper keeper(here / "pictures", 100, 0);
  EXPECT_EQ(keptOf(keeper, 100), 0u);
  keeper.begin(std::vector<Method>{Method::kLdi});
  EXPECT_TRUE(here.names().empty());
}

TEST(PictureKeeper, PicturesAreSmallJpegsOfTheFrameNamedByMethodAndFrame) {
  const TemporaryFolder here;
  const PictureKeeper keeper(here / "pictures", 100, 10);
  keeper.begin(std::vector<Method>{Method::kLdi});
  keeper.keep(Method::kLdi, 20, halves(700, 512));
  const std::string file = here / "pictures/ldi/00020.jpg";
  ASSERT_TRUE(textOf(file).starts_with("\xff\xd8\xff"));
  const Image kept = readImage(file);
  EXPECT_LE(kept.width, kKeptWidth);
  EXPECT_GT(kept.width, kKeptWidth / 2);
  EXPECT_NEAR(static_cast<double>(kept.width) / kept.height, 700.0 / 512.0, 0.01);
  EXPECT_LT(kept.rgba[0], 8);
  EXPECT_GT(kept.rgba[static_cast<std::size_t>(4 * (kept.width - 1))], 247);
}

TEST(PictureKeeper, SmallAndVeryWidePicturesStayWhole) {
  EXPECT_EQ(keptSize(halves(96, 80)).width, 96);
  const Image wide = keptSize(halves(16384, 16));
  EXPECT_GE(wide.height, 1);
  EXPECT_EQ(wide.rgba.size(),
            4 * static_cast<std::size_t>(wide.width) * static_cast<std::size_t>(wide.height));
}

}  // namespace
}  // namespace enfilade
