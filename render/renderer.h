#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/gl_context.h"
#include "scene/building.h"
#include "scene/camera.h"
#include "scene/image.h"

namespace enfilade {

/// The colour where nothing is drawn: a pale sky, sRGB.
inline constexpr std::uint8_t kSkyColor[4] = {178, 205, 235, 255};

/// A picture and the depth buffer behind it, row 0 on top.
struct DepthPicture {
  Image color;
  std::vector<float> depth;  ///< OpenGL depth 0…1, one a pixel, 1 where nothing is
};

/// A textured convex polygon whose colour is read from a picture the size of the frame, at each
/// pixel's own place: how a warped image stands in a portal.
struct ScreenPolygon {
  std::vector<glm::vec3> polygon;  ///< world [m]
};

struct DrawCounts {
  std::size_t triangles = 0;
  std::size_t draw_calls = 0;
};

/// Draws a building's objects by OpenGL into a framebuffer of its own.
/// Colour = base colour × texture × vertex colour × a sky and sun term of the normal, none of which
/// depends on the viewpoint (back faces of double-sided material are lit by their reversed normal).
/// Masked material is tested, blended material drawn last, farthest object first.  Opaque objects
/// are drawn in increasing order, so that a subset of the objects draws the same pixels wherever it
/// holds all that is seen. Row 0 of what it returns is the top row.
class Renderer {
 public:
  /// Uploads the building.  Both must outlive the renderer.  Throws Error (kMachine).
  Renderer(GlContext& context, const Building& building);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Starts a frame of this size with the sky, and ends that of any other renderer of the context:
  /// it may still be read, but not drawn into.  Throws Error (kMachine) if the size is more than
  /// the machine can.
  void begin(int width, int height);

  /// Draws `objects` (increasing).  The view's eye orders blended objects.
  DrawCounts draw(std::span<const std::uint32_t> objects, const View& view);

  /// Draws `polygons` at their own depth, colour by pixel position from `picture` (the frame's
  /// size).  Where the picture's alpha is 0 the pixel stays as it is.  Call it before draw(), so
  /// that what stands in front hides it. To keep uploads small only the rows and columns in
  /// `region` (x0, y0, x1, y1, top row 0) are read from `picture`.
  void drawScreenPolygons(std::span<const ScreenPolygon> polygons, const Image& picture,
                          const glm::ivec4& region, const glm::mat4& clip_from_world);

  /// Draws one convex polygon with `texture` mapped on it: `texcoords` one a corner, v = 0 is the
  /// top row.  A texture with a `key` but 0 stays uploaded for later frames, so that the same key
  /// must always mean the same texture; at most 64 MiB of them, those drawn last.
  void drawTexturedPolygon(std::span<const glm::vec3> polygon, std::span<const glm::vec2> texcoords,
                           const Image& texture, const glm::mat4& clip_from_world,
                           std::uint64_t key = 0);

  /// Whether draw() leaves out the triangles that cover no pixel's centre, which changes no pixel
  /// but the time that it takes.  So from the start; off for comparisons.
  void setSifting(bool sifting);

  /// Textures are read `levels` mip levels coarser from now on: for pictures several of whose
  /// pixels become one, whose textures are to be as smooth as that one's.
  void setTextureBias(float levels);

  /// Whether draw() draws triangles' edges alone, all of them.
  void setWireframe(bool wireframe);

  /// Waits until all is drawn.
  void finish();

  /// Copies the frame to the context's own framebuffer (a window's), stretched to its size: of its
  /// columns the share from `left` to `right`, 0…1.
  void show(int window_width, int window_height, float left = 0, float right = 1);

  void readColor(Image& out);  ///< resized to the frame; never allocates when the size is the same
  void readDepth(std::vector<float>& out);

  /// Which of `polygons` each pixel shows: 0 none, else 1 + the index of the nearest one that
  /// nothing drawn stands before (of more than 255 polygons the last ones share 255).  Pixels that
  /// a screen polygon's picture left transparent are the polygon's too, whatever shows through
  /// there. The polygons are those that were drawn.  Call it last: the colours stay, the depth does
  /// not.
  void readVisible(std::span<const ScreenPolygon> polygons, const glm::mat4& clip_from_world,
                   std::vector<std::uint8_t>& out);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace enfilade
