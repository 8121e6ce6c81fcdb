#include "render/overlay_painter.h"

#include <algorithm>
#include <cmath>

#include "render/gl_program.h"

namespace enfilade {

namespace {

constexpr int kAtlasSide = 1024;

const char* const kVertexShader = R"(#version 330 core
uniform vec2 to_clip;
in vec2 at;
in vec2 texcoord;
in vec4 color;
out vec2 v_texcoord;
out vec4 v_color;
void main() {
  gl_Position = vec4(at.x * to_clip.x - 1.0, 1.0 - at.y * to_clip.y, 0.0, 1.0);
  v_texcoord = texcoord;
  v_color = color;
}
)";

const char* const kFragmentShader = R"(#version 330 core
uniform sampler2D image;
in vec2 v_texcoord;
in vec4 v_color;
out vec4 pixel;
void main() { pixel = v_color * texture(image, v_texcoord); }
)";

constexpr const char* kAttributes[] = {"at", "texcoord", "color"};

}  // namespace

struct OverlayPainter::Letters {
  Letters(float pixels, FontFace face) : font(pixels, face) {}
  Font font;
  std::map<char32_t, Place> places;
};

OverlayPainter::OverlayPainter(GlContext& context)
    : context_((context.makeCurrent(), context)), gl_(context.gl()) {
  program_ = createProgram(gl_, kVertexShader, kFragmentShader, kAttributes);
  to_clip_ = gl_.GetUniformLocation(program_, "to_clip");
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(1, &buffer_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  const auto attribute = [&](GLuint index, GLint numbers, std::size_t offset) {
    gl_.EnableVertexAttribArray(index);
    gl_.VertexAttribPointer(index, numbers, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                            reinterpret_cast<const void*>(offset));  // NOLINT
  };
  attribute(0, 2, offsetof(Vertex, at));
  attribute(1, 2, offsetof(Vertex, texcoord));
  attribute(2, 4, offsetof(Vertex, color));
  clearAtlas();
}

OverlayPainter::~OverlayPainter() {
  context_.makeCurrent();
  gl_.DeleteProgram(program_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(1, &buffer_);
  gl_.DeleteTextures(1, &atlas_.name);
  for (const auto& [slot, texture] : pictures_) gl_.DeleteTextures(1, &texture.name);
}

/// An empty atlas but for the white pixel that boxes and lines are drawn with.
void OverlayPainter::clearAtlas() {
  atlas_.bind(gl_, glm::ivec2(kAtlasSide), false);
  const std::vector<std::uint8_t> empty(std::size_t{4} * kAtlasSide * kAtlasSide, 0);
  const std::uint8_t white[4] = {255, 255, 255, 255};
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kAtlasSide, kAtlasSide, GL_RGBA, GL_UNSIGNED_BYTE,
                    empty.data());
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
  pen_ = {2, 0};
  row_height_ = 2;
  for (auto& [key, letters] : letters_) letters->places.clear();
}

void OverlayPainter::begin(const glm::ivec2& window) {
  context_.makeCurrent();
  window_ = glm::max(window, 1);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, window_.x, window_.y);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindSampler(0, 0);
  vertices_.clear();
  in_use_ = 0;
}

void OverlayPainter::end() {
  flush();
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_SCISSOR_TEST);
}

void OverlayPainter::flush() {
  if (vertices_.empty()) return;
  gl_.UseProgram(program_);
  gl_.Uniform2f(to_clip_, 2.0f / static_cast<float>(window_.x),
                2.0f / static_cast<float>(window_.y));
  gl_.BindTexture(GL_TEXTURE_2D, in_use_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)),
                 vertices_.data(), GL_STREAM_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
  vertices_.clear();
}

void OverlayPainter::use(GLuint texture) {
  if (texture != in_use_) flush();
  in_use_ = texture;
}

void OverlayPainter::quad(const PixelBox& box, const PixelBox& texcoords,
                          const OverlayColor& color) {
  const auto corner = [&](int x, int y) {
    const PixelBox& t = texcoords;
    vertices_.push_back({{x != 0 ? box.high.x : box.low.x, y != 0 ? box.high.y : box.low.y},
                         {x != 0 ? t.high.x : t.low.x, y != 0 ? t.high.y : t.low.y},
                         color});
  };
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) corner(x, y);
}

void OverlayPainter::box(const PixelBox& box, const OverlayColor& color) {
  use(atlas_.name);
  const glm::vec2 white(0.5f / kAtlasSide);
  quad(box, {white, white}, color);
}

void OverlayPainter::triangle(const std::array<glm::vec2, 3>& corners, const OverlayColor& color) {
  use(atlas_.name);
  for (const glm::vec2& corner : corners) {
    vertices_.push_back({corner, glm::vec2(0.5f / kAtlasSide), color});
  }
}

void OverlayPainter::line(const glm::vec2& from, const glm::vec2& to, float width,
                          const OverlayColor& color) {
  const float length = glm::length(to - from);
  if (!(length > 0)) return;
  const glm::vec2 along = (to - from) / length;
  const glm::vec2 half = 0.5f * width * glm::vec2(-along.y, along.x);
  triangle({from - half, from + half, to + half}, color);
  triangle({from - half, to + half, to - half}, color);
}

OverlayPainter::Letters& OverlayPainter::letters(const TextStyle& style) {
  const int pixels = std::clamp(static_cast<int>(std::lround(style.size)), 6, 200);
  std::unique_ptr<Letters>& letters = letters_[{pixels, style.face}];
  if (!letters) letters = std::make_unique<Letters>(static_cast<float>(pixels), style.face);
  return *letters;
}

OverlayPainter::Place OverlayPainter::place(Letters& letters, char32_t character,
                                            const Glyph& glyph) {
  const auto found = letters.places.find(character);
  if (found != letters.places.end()) return found->second;
  const glm::ivec2 room = glyph.size + 1;  // a gap between neighbours
  if (pen_.x + room.x > kAtlasSide) {
    pen_ = {0, pen_.y + row_height_};
    row_height_ = 0;
  }
  if (pen_.y + room.y > kAtlasSide) {
    flush();  // what is drawn already must keep its letters
    clearAtlas();
  }
  std::vector<std::uint8_t> texels;
  for (const std::uint8_t coverage : glyph.coverage) {
    texels.insert(texels.end(), {255, 255, 255, coverage});
  }
  gl_.BindTexture(GL_TEXTURE_2D, atlas_.name);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, pen_.x, pen_.y, glyph.size.x, glyph.size.y, GL_RGBA,
                    GL_UNSIGNED_BYTE, texels.data());
  const Place placed{pen_, glyph.size};
  pen_.x += room.x;
  row_height_ = std::max(row_height_, room.y);
  return letters.places[character] = placed;
}

void OverlayPainter::text(std::string_view text, const glm::vec2& at, const TextStyle& style) {
  Letters& letters = this->letters(style);
  use(atlas_.name);
  letters.font.layOut(text, at, [&](char32_t character, const Glyph& glyph, const glm::ivec2& low) {
    if (glyph.coverage.empty()) return;
    const Place where = place(letters, character, glyph);
    const glm::vec2 first(low);
    quad({first, first + glm::vec2(where.size)},
         {glm::vec2(where.low) / float{kAtlasSide},
          glm::vec2(where.low + where.size) / float{kAtlasSide}},
         style.color);
  });
}

float OverlayPainter::textWidth(std::string_view text, const TextStyle& style) {
  return letters(style).font.width(text);
}

float OverlayPainter::lineHeight(const TextStyle& style) {
  return letters(style).font.lineHeight();
}

void OverlayPainter::picture(const PixelBox& box, const Image& picture, int slot, bool changed,
                             bool smooth) {
  if (picture.rgba.empty()) return;
  flush();
  PictureTexture& texture = pictures_[slot];
  const glm::ivec2 size(picture.width, picture.height);
  changed |= texture.size != size;
  texture.bind(gl_, size, smooth);
  if (changed) {
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                      picture.rgba.data());
  }
  use(texture.name);
  quad(box, {glm::vec2(0), glm::vec2(1)}, OverlayColor(1));
  flush();
}

void OverlayPainter::clipTo(const PixelBox& clip) {
  flush();
  const glm::ivec2 low(glm::round(glm::max(clip.low, glm::vec2(0))));
  const glm::ivec2 high(glm::round(glm::min(clip.high, glm::vec2(window_))));
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(low.x, window_.y - high.y, std::max(high.x - low.x, 0), std::max(high.y - low.y, 0));
}

Image OverlayPainter::read() {
  Image bottom_up;
  bottom_up.width = window_.x;
  bottom_up.height = window_.y;
  const auto row = 4 * static_cast<std::size_t>(window_.x);
  bottom_up.rgba.resize(row * static_cast<std::size_t>(window_.y));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.ReadPixels(0, 0, window_.x, window_.y, GL_RGBA, GL_UNSIGNED_BYTE, bottom_up.rgba.data());
  Image picture = bottom_up;
  for (std::size_t y = 0; y < static_cast<std::size_t>(window_.y); ++y) {
    const auto from = bottom_up.rgba.begin() + static_cast<std::ptrdiff_t>(y * row);
    std::copy_n(from, row, picture.rgba.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
  }
  for (std::size_t a = 3; a < picture.rgba.size(); a += 4) picture.rgba[a] = 255;
  return picture;
}

}  // namespace enfilade
