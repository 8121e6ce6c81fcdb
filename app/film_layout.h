#pragma once

#include <glm/glm.hpp>

#include "scene/image.h"

namespace enfilade {

/// How the pictures of several methods stand in a film's frame: each as large as it is by itself,
/// side by side; more than three in two rows.
class FilmLayout {
 public:
  /// Of `panels` pictures of `panel` pixels each.
  FilmLayout(int panels, const glm::ivec2& panel);

  /// Of the film's frame [pixels], even both ways, as video's colours are for 2 × 2 pixels.
  const glm::ivec2& size() const noexcept { return size_; }

  /// The upper left pixel of picture `i`.
  glm::ivec2 corner(int i) const;

  /// A frame with no picture in it yet.
  Image emptyFrame() const;

  /// Puts `picture` in its place; a row or column that makes the size even repeats the one before.
  void place(const Image& picture, int i, Image& frame) const;

 private:
  glm::ivec2 panel_;
  int columns_;
  glm::ivec2 size_;
};

}  // namespace enfilade
