#include "app/film_layout.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

Image flat(const glm::ivec2& size, std::uint8_t level) {
  Image image;
  image.width = size.x;
  image.height = size.y;
  image.rgba.assign(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), level);
  return image;
}

TEST(FilmLayout, OfOneEvenPictureIsThePicture) {
  const FilmLayout layout(1, {640, 512});
  EXPECT_EQ(layout.size(), glm::ivec2(640, 512));
  Image frame = layout.emptyFrame();
  const Image picture = flat({640, 512}, 77);
  layout.place(picture, 0, frame);
  EXPECT_EQ(frame.rgba, picture.rgba);
}

TEST(FilmLayout, IsEvenAndHoldsEveryPictureWhole) {
  for (const glm::ivec2 panel : {glm::ivec2(640, 512), {81, 65}, {16, 17}}) {
    for (int panels = 1; panels <= 7; ++panels) {
      const FilmLayout layout(panels, panel);
      EXPECT_EQ(layout.size() % 2, glm::ivec2(0));
      Image frame = layout.emptyFrame();
      for (int i = 0; i < panels; ++i) {
        layout.place(flat(panel, static_cast<std::uint8_t>(100 + i)), i, frame);
      }
      std::vector<int> pixels(256);
      for (std::size_t p = 0; p < frame.rgba.size(); p += 4) ++pixels[frame.rgba[p]];
      for (int i = 0; i < panels; ++i) {
        const int area = panel.x * panel.y;
        EXPECT_GE(pixels[static_cast<std::size_t>(100 + i)], area) << "one lies over another";
        EXPECT_LE(pixels[static_cast<std::size_t>(100 + i)], area + panel.x + panel.y + 1);
      }
    }
  }
}

TEST(FilmLayout, HasThreeInARowAndMoreInTwo) {
  EXPECT_EQ(FilmLayout(2, {640, 512}).size(), glm::ivec2(1284, 512));
  EXPECT_EQ(FilmLayout(3, {640, 512}).size(), glm::ivec2(1928, 512));
  EXPECT_EQ(FilmLayout(4, {640, 512}).size(), glm::ivec2(1284, 1028));
  EXPECT_EQ(FilmLayout(4, {640, 512}).corner(3), glm::ivec2(644, 516));
}

TEST(FilmLayout, RepeatsTheLastRowAndColumnOfOddPictures) {
  const FilmLayout layout(2, {3, 5});
  ASSERT_EQ(layout.size(), glm::ivec2(10, 6));
  Image frame = layout.emptyFrame();
  layout.place(flat({3, 5}, 200), 0, frame);
  layout.place(flat({3, 5}, 100), 1, frame);
  const auto at = [&](int x, int y) {
    return frame.rgba[4 * static_cast<std::size_t>(10 * y + x)];
  };
  EXPECT_EQ(at(2, 5), 200);
  EXPECT_EQ(at(9, 5), 100);
  EXPECT_NE(at(3, 5), 200);
}

}  // namespace
}  // namespace enfilade
