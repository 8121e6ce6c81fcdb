#include "render/polygon_painter.h"

#include <algorithm>
#include <cassert>

#include "render/gl_program.h"
#include "render/renderer_shaders.h"

namespace enfilade {

namespace {

constexpr std::size_t kMostKeptBytes = std::size_t{64} << 20;

}  // namespace

PolygonPainter::PolygonPainter(const GlFunctions& gl) : gl_(gl) {
  screen_program_ =
      createProgram(gl, kPolygonVertexShader, kScreenPolygonFragmentShader, kPolygonAttributes);
  textured_program_ =
      createProgram(gl, kPolygonVertexShader, kTexturedPolygonFragmentShader, kPolygonAttributes);
  mark_program_ = createProgram(gl, kPolygonVertexShader, kMarkFragmentShader, kPolygonAttributes);
  gl.GenVertexArrays(1, &vertex_array_);
  gl.GenBuffers(1, &buffer_);
  gl.BindVertexArray(vertex_array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl.EnableVertexAttribArray(0);
  gl.EnableVertexAttribArray(1);
  const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };  // NOLINT
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), at(offsetof(Vertex, position)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), at(offsetof(Vertex, texcoord)));
}

PolygonPainter::~PolygonPainter() {
  gl_.DeleteProgram(screen_program_);
  gl_.DeleteProgram(textured_program_);
  gl_.DeleteProgram(mark_program_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(1, &buffer_);
  for (const PictureTexture& texture : textures_) gl_.DeleteTextures(1, &texture.name);
  for (const auto& [key, kept] : kept_) gl_.DeleteTextures(1, &kept.texture.name);
}

void PolygonPainter::bindTexture(int width, int height, bool by_pixel) {
  if (used_ == textures_.size()) textures_.emplace_back();
  textures_[used_++].bind(gl_, {width, height}, !by_pixel);
}

void PolygonPainter::bindKept(const Image& image, std::uint64_t key) {
  KeptTexture& kept = kept_[key];
  const bool is_new = kept.texture.name == 0;
  kept.frame = frame_;
  kept.texture.bind(gl_, {image.width, image.height}, true);
  if (!is_new) return;
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.rgba.data());
  kept.bytes = image.rgba.size();
  kept_bytes_ += kept.bytes;
  dropOldTextures();
}

void PolygonPainter::dropOldTextures() {
  while (kept_bytes_ > kMostKeptBytes) {
    const auto oldest = std::min_element(kept_.begin(), kept_.end(), [](auto& a, auto& b) {
      return a.second.frame < b.second.frame;
    });
    if (oldest->second.frame == frame_) return;  // all are in this frame
    gl_.DeleteTextures(1, &oldest->second.texture.name);
    kept_bytes_ -= oldest->second.bytes;
    kept_.erase(oldest);
  }
}

void PolygonPainter::drawTriangles(GLuint program, const glm::mat4& clip_from_world) {
  gl_.UseProgram(program);
  gl_.UniformMatrix4fv(gl_.GetUniformLocation(program, "clip_from_world"), 1, GL_FALSE,
                       &clip_from_world[0][0]);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles_.size() * sizeof(Vertex)),
                 triangles_.data(), GL_STREAM_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles_.size()));
}

void PolygonPainter::drawScreenPolygons(std::span<const ScreenPolygon> polygons,
                                        const Image& picture, const glm::ivec4& region,
                                        const glm::mat4& clip_from_world) {
  const glm::ivec2 low = glm::max(glm::ivec2(region), glm::ivec2(0));
  const glm::ivec2 high =
      glm::min(glm::ivec2(region.z, region.w), glm::ivec2(picture.width, picture.height));
  triangles_.clear();
  for (const ScreenPolygon& screen : polygons) addTriangles(screen.polygon, {});
  if (low.x >= high.x || low.y >= high.y || triangles_.empty()) return;
  bindTexture(picture.width, picture.height, true);
  const std::size_t start =
      4 * (static_cast<std::size_t>(low.y) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(low.x));
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, picture.width);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, low.x, low.y, high.x - low.x, high.y - low.y, GL_RGBA,
                    GL_UNSIGNED_BYTE, &picture.rgba[start]);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  // Outside the region the texture holds what an earlier frame left there.
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(low.x, low.y, high.x - low.x, high.y - low.y);
  drawTriangles(screen_program_, clip_from_world);
  gl_.Disable(GL_SCISSOR_TEST);
}

void PolygonPainter::drawTexturedPolygon(std::span<const glm::vec3> polygon,
                                         std::span<const glm::vec2> texcoords, const Image& texture,
                                         const glm::mat4& clip_from_world, std::uint64_t key) {
  assert(polygon.size() == texcoords.size());
  triangles_.clear();
  addTriangles(polygon, texcoords);
  if (triangles_.empty() || texture.rgba.empty()) return;
  if (key != 0) {
    bindKept(texture, key);
  } else {
    bindTexture(texture.width, texture.height, false);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.width, texture.height, GL_RGBA,
                      GL_UNSIGNED_BYTE, texture.rgba.data());
  }
  drawTriangles(textured_program_, clip_from_world);
}

void PolygonPainter::addTriangles(std::span<const glm::vec3> polygon,
                                  std::span<const glm::vec2> texcoords) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
      const glm::vec2 texcoord = texcoords.empty() ? glm::vec2(0) : texcoords[corner];
      triangles_.push_back({polygon[corner], texcoord});
    }
  }
}

void PolygonPainter::setAlphaOfAll(float alpha) {
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl_.ClearColor(0, 0, 0, alpha);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void PolygonPainter::markVisible(std::span<const ScreenPolygon> polygons,
                                 const glm::mat4& clip_from_world) {
  setAlphaOfAll(0);
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  // Where the polygon was drawn its own depth stands, where it was transparent a greater one.
  // Backwards, so that of polygons at one depth the first stays, as when they were drawn.
  gl_.DepthFunc(GL_LEQUAL);
  for (std::size_t i = polygons.size(); i-- > 0;) {
    triangles_.clear();
    addTriangles(polygons[i].polygon, {});
    if (triangles_.empty()) continue;
    gl_.UseProgram(mark_program_);
    gl_.Uniform1f(gl_.GetUniformLocation(mark_program_, "mark"),
                  static_cast<float>(std::min<std::size_t>(i + 1, 255)) / 255.0f);
    drawTriangles(mark_program_, clip_from_world);
  }
  gl_.DepthFunc(GL_LESS);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void PolygonPainter::clearMarks() { setAlphaOfAll(1); }

}  // namespace enfilade
