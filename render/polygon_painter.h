#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <vector>

#include "render/gl_functions.h"
#include "render/picture_texture.h"
#include "render/renderer.h"

namespace enfilade {

/// Draws the polygons that stand in portals, under the depth state that it finds.  The context must
/// be current and the framebuffer bound.
class PolygonPainter {
 public:
  explicit PolygonPainter(const GlFunctions& gl);
  ~PolygonPainter();
  PolygonPainter(const PolygonPainter&) = delete;
  PolygonPainter& operator=(const PolygonPainter&) = delete;

  /// A new frame: textures may be written again without waiting for those who read them.
  void begin() noexcept {
    used_ = 0;
    ++frame_;
  }

  /// See Renderer::drawScreenPolygons.
  void drawScreenPolygons(std::span<const ScreenPolygon> polygons, const Image& picture,
                          const glm::ivec4& region, const glm::mat4& clip_from_world);
  /// See Renderer::drawTexturedPolygon.
  void drawTexturedPolygon(std::span<const glm::vec3> polygon, std::span<const glm::vec2> texcoords,
                           const Image& texture, const glm::mat4& clip_from_world,
                           std::uint64_t key);

  /// Sets the frame's alpha to what Renderer::readVisible returns, in 255ths, and nothing else but
  /// depth.
  void markVisible(std::span<const ScreenPolygon> polygons, const glm::mat4& clip_from_world);
  /// Sets the frame's alpha to 1 again.
  void clearMarks();

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec2 texcoord;
  };

  /// A texture that stays uploaded from frame to frame.
  struct KeptTexture {
    PictureTexture texture;
    std::size_t bytes = 0;
    std::uint64_t frame = 0;  ///< when it was drawn last
  };

  void bindTexture(int width, int height, bool by_pixel);
  /// `texcoords`: one a corner, or none.
  void addTriangles(std::span<const glm::vec3> polygon, std::span<const glm::vec2> texcoords);
  void setAlphaOfAll(float alpha);
  void bindKept(const Image& image, std::uint64_t key);
  void dropOldTextures();
  void drawTriangles(GLuint program, const glm::mat4& clip_from_world);

  const GlFunctions& gl_;
  GLuint screen_program_ = 0;
  GLuint textured_program_ = 0;
  GLuint mark_program_ = 0;
  GLuint vertex_array_ = 0;
  GLuint buffer_ = 0;
  std::vector<Vertex> triangles_;
  std::vector<PictureTexture> textures_;  // one for each use in a frame, kept for the next
  std::size_t used_ = 0;
  std::map<std::uint64_t, KeptTexture> kept_;  // by key
  std::size_t kept_bytes_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace enfilade
