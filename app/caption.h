#pragma once

#include <glm/glm.hpp>
#include <string>

#include "render/font.h"
#include "scene/image.h"

namespace enfilade {

/// What is written into a method's picture.
struct Caption {
  std::string name;
  double frame_ms = 0;   ///< of the frame at hand
  double median_ms = 0;  ///< of the walk
};

/// Pixels [low, high).
struct PixelRange {
  glm::ivec2 low{0}, high{0};
};

/// Writes captions into pictures: a dark box in the upper left corner, text as large as the picture
/// has room for.
class CaptionPainter {
 public:
  /// For pictures of `panel` pixels.
  explicit CaptionPainter(const glm::ivec2& panel);

  /// The pixels of a picture that `caption` takes: the same whatever the frame's time, up to
  /// 9999.9 ms.
  PixelRange box(const Caption& caption);

  /// Writes it into the picture whose upper left corner is `corner` of `frame`.
  void draw(const Caption& caption, const glm::ivec2& corner, Image& frame);

 private:
  float figuresWidth(const Caption& caption);
  void write(Font& font, const std::string& text, const glm::vec2& at, const PixelRange& within,
             Image& frame);

  glm::ivec2 panel_;
  Font figures_, name_;
  float padding_;  ///< [pixels] within the box; its distance from the corner too
};

}  // namespace enfilade
