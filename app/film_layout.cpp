#include "app/film_layout.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace enfilade {

namespace {

constexpr int kGap = 4;               ///< [pixels] between pictures
constexpr int kMostInARow = 3;        ///< as wide as a screen of 1920 pixels by default
constexpr std::uint8_t kGround = 24;  ///< grey level of what shows no picture

}  // namespace

FilmLayout::FilmLayout(int panels, const glm::ivec2& panel)
    : panel_(panel), columns_(panels <= kMostInARow ? panels : (panels + 1) / 2) {
  const int rows = (panels + columns_ - 1) / columns_;
  const glm::ivec2 cells(columns_, rows);
  size_ = cells * panel + (cells - 1) * kGap;
  size_ += size_ % 2;
}

glm::ivec2 FilmLayout::corner(int i) const {
  return glm::ivec2(i % columns_, i / columns_) * (panel_ + kGap);
}

Image FilmLayout::emptyFrame() const {
  Image frame;
  frame.width = size_.x;
  frame.height = size_.y;
  frame.rgba.assign(4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y),
                    kGround);
  return frame;
}

void FilmLayout::place(const Image& picture, int i, Image& frame) const {
  assert(glm::ivec2(picture.width, picture.height) == panel_);
  const glm::ivec2 at = corner(i);
  const auto pixel = [](const Image& image, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                static_cast<std::size_t>(x));
  };
  // What is left to the frame's edge is at most one pixel where this is the last of its row.
  const glm::ivec2 end = glm::min(at + panel_ + 1, size_);
  const bool last_column = end.x - at.x > panel_.x && end.x == size_.x;
  const bool last_row = end.y - at.y > panel_.y && end.y == size_.y;
  for (int y = 0; y < panel_.y + (last_row ? 1 : 0); ++y) {
    const std::size_t from = pixel(picture, 0, std::min(y, panel_.y - 1));
    const std::size_t to = pixel(frame, at.x, at.y + y);
    const std::size_t bytes = 4 * static_cast<std::size_t>(panel_.x);
    std::memcpy(&frame.rgba[to], &picture.rgba[from], bytes);
    if (last_column) std::memcpy(&frame.rgba[to + bytes], &frame.rgba[to + bytes - 4], 4);
  }
}

}  // namespace enfilade
