#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "render/font.h"
#include "render/gl_context.h"
#include "render/picture_texture.h"
#include "scene/image.h"

namespace enfilade {

/// sRGB and alpha, 0…1.
using OverlayColor = glm::vec4;

/// An upright rectangle [pixels], y down.
struct PixelBox {
  glm::vec2 low{0}, high{0};

  glm::vec2 size() const { return high - low; }
  bool contains(const glm::vec2& p) const {
    return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y;
  }
};

/// How a text stands.
struct TextStyle {
  float size = 15;  ///< [pixels] of a line
  FontFace face = FontFace::kRegular;
  OverlayColor color{1, 1, 1, 1};
};

/// Draws flat things over a window's picture: panels, lines, text, pictures.  Positions in pixels
/// of the window, (0, 0) its upper left corner, y down.  What is drawn later lies on top.
class OverlayPainter {
 public:
  /// The context must outlive it.  Throws Error (kMachine).
  explicit OverlayPainter(GlContext& context);
  ~OverlayPainter();
  OverlayPainter(const OverlayPainter&) = delete;
  OverlayPainter& operator=(const OverlayPainter&) = delete;

  /// Draws into the context's own framebuffer from now on, whose size this is [pixels].
  void begin(const glm::ivec2& window);
  /// All that was drawn since begin() gets there.
  void end();

  glm::vec2 size() const { return glm::vec2(window_); }

  void box(const PixelBox& box, const OverlayColor& color);
  void triangle(const std::array<glm::vec2, 3>& corners, const OverlayColor& color);
  void line(const glm::vec2& from, const glm::vec2& to, float width, const OverlayColor& color);
  /// `at`: the upper left corner of a line of UTF-8 text.
  void text(std::string_view text, const glm::vec2& at, const TextStyle& style);
  float textWidth(std::string_view text, const TextStyle& style);
  float lineHeight(const TextStyle& style);

  /// `picture` stretched over `box`.  `slot`: pictures of one slot share a texture, which is
  /// written anew only when `changed`.
  void picture(const PixelBox& box, const Image& picture, int slot, bool changed = true,
               bool smooth = true);
  /// What is drawn from now on shows within `clip` alone.
  void clipTo(const PixelBox& clip);

  /// What the framebuffer shows.
  Image read();

 private:
  struct Vertex {
    glm::vec2 at;
    glm::vec2 texcoord;
    glm::vec4 color;
  };
  struct Place {
    glm::ivec2 low{0}, size{0};  // in the atlas
  };
  struct Letters;  // of one font

  void quad(const PixelBox& box, const PixelBox& texcoords, const OverlayColor& color);
  void flush();
  void use(GLuint texture);
  Letters& letters(const TextStyle& style);
  Place place(Letters& letters, char32_t character, const Glyph& glyph);
  void clearAtlas();

  GlContext& context_;
  const GlFunctions& gl_;
  glm::ivec2 window_{1};
  GLuint program_ = 0, vertex_array_ = 0, buffer_ = 0;
  GLint to_clip_ = -1;
  std::vector<Vertex> vertices_;
  GLuint in_use_ = 0;     // the texture of vertices_
  PictureTexture atlas_;  // glyphs, and a white pixel at (0, 0)
  glm::ivec2 pen_{0};     // where the next glyph goes
  int row_height_ = 0;
  std::map<std::pair<int, FontFace>, std::unique_ptr<Letters>> letters_;  // by size and face
  std::map<int, PictureTexture> pictures_;
};

}  // namespace enfilade
