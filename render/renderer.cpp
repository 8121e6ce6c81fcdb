#include "render/renderer.h"

#include <array>
#include <cassert>
#include <cmath>

#include "render/frame_buffer.h"
#include "render/object_painter.h"
#include "render/polygon_painter.h"

namespace enfilade {
namespace {

/// Window rows grow upwards in OpenGL.  We draw upside down, so that row 0 is the top row and
/// reading back needs no turning; what was counter-clockwise is clockwise then.
glm::mat4 upsideDown(const glm::mat4& clip_from_world) {
  glm::mat4 m = clip_from_world;
  for (int column = 0; column < 4; ++column) m[column][1] = -m[column][1];
  return m;
}

}  // namespace

struct Renderer::Impl {
  Impl(GlContext& gl_context, const Building& building)
      : context((gl_context.makeCurrent(), gl_context)),
        gl(gl_context.gl()),
        frames{FrameBuffer(gl), FrameBuffer(gl)},
        objects(gl, building),
        polygons(gl) {
    gl.GetIntegerv(GL_SUBPIXEL_BITS, &sub_pixel_bits);
  }

  ~Impl() { context.makeCurrent(); }  // the members have names in it to delete

  void begin(int width, int height);

  /// The framebuffer of the frame begun last.
  FrameBuffer& frame() noexcept { return frames[current]; }

  /// Another renderer of the context may have had its framebuffer bound since.
  void rebind() {
    context.makeCurrent();
    frame().bind(frame().width(), frame().height());
  }

  GlContext& context;
  const GlFunctions& gl;
  // Two, so that captures of other sizes between frames leave the frames' own buffer as it is.
  std::array<FrameBuffer, 2> frames;
  std::size_t current = 0;
  ObjectPainter objects;
  PolygonPainter polygons;
  GLint sub_pixel_bits = 4;
  bool sifting = true;
  bool wireframe = false;
};

void Renderer::Impl::begin(int width, int height) {
  context.makeCurrent();
  const bool fits = frame().width() == width && frame().height() == height;
  const std::size_t next = fits ? current : 1 - current;
  frames[next].bind(width, height);
  current = next;
  polygons.begin();
  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DITHER);  // on at first, and some GPUs would: a colour is a colour wherever it is
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);  // of coplanar faces the first drawn stays
  gl.DepthMask(GL_TRUE);
  gl.FrontFace(GL_CW);  // as it looks upside down
  gl.CullFace(GL_BACK);
  gl.ClearColor(kSkyColor[0] / 255.0f, kSkyColor[1] / 255.0f, kSkyColor[2] / 255.0f, 1.0f);
  gl.ClearDepth(1.0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Renderer::Renderer(GlContext& context, const Building& building)
    : impl_(std::make_unique<Impl>(context, building)) {}

Renderer::~Renderer() = default;

void Renderer::begin(int width, int height) { impl_->begin(width, height); }

DrawCounts Renderer::draw(std::span<const std::uint32_t> objects, const View& view) {
  if (impl_->wireframe) impl_->gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  const DrawCounts counts =
      impl_->objects.draw(objects, view.eye,
                          {upsideDown(view.clip_from_world), impl_->frame().width(),
                           impl_->frame().height(), impl_->sub_pixel_bits});
  if (impl_->wireframe) impl_->gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  return counts;
}

void Renderer::drawScreenPolygons(std::span<const ScreenPolygon> polygons, const Image& picture,
                                  const glm::ivec4& region, const glm::mat4& clip_from_world) {
  assert(picture.width == impl_->frame().width() && picture.height == impl_->frame().height());
  impl_->polygons.drawScreenPolygons(polygons, picture, region, upsideDown(clip_from_world));
}

void Renderer::drawTexturedPolygon(std::span<const glm::vec3> polygon,
                                   std::span<const glm::vec2> texcoords, const Image& texture,
                                   const glm::mat4& clip_from_world, std::uint64_t key) {
  impl_->polygons.drawTexturedPolygon(polygon, texcoords, texture, upsideDown(clip_from_world),
                                      key);
}

void Renderer::setSifting(bool sifting) {
  impl_->sifting = sifting;
  impl_->objects.setSifting(sifting && !impl_->wireframe);
}

void Renderer::setWireframe(bool wireframe) {
  impl_->wireframe = wireframe;
  setSifting(impl_->sifting);  // a triangle without a pixel's centre has edges to show
}

void Renderer::setTextureBias(float levels) {
  impl_->context.makeCurrent();
  impl_->objects.setTextureBias(levels);
}

void Renderer::finish() { impl_->gl.Finish(); }

void Renderer::show(int window_width, int window_height, float left, float right) {
  const GlFunctions& gl = impl_->gl;
  impl_->rebind();
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  const auto column = [](float share, int width) {
    return static_cast<int>(std::lround(share * static_cast<float>(width)));
  };
  const int width = impl_->frame().width();
  // A window's row 0 is at the bottom.
  gl.BlitFramebuffer(column(left, width), 0, column(right, width), impl_->frame().height(),
                     column(left, window_width), window_height, column(right, window_width), 0,
                     GL_COLOR_BUFFER_BIT, GL_LINEAR);
  impl_->rebind();
}

void Renderer::readColor(Image& out) {
  out.width = impl_->frame().width();
  out.height = impl_->frame().height();
  out.rgba.resize(4 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  impl_->rebind();
  impl_->gl.ReadPixels(0, 0, out.width, out.height, GL_RGBA, GL_UNSIGNED_BYTE, out.rgba.data());
}

void Renderer::readVisible(std::span<const ScreenPolygon> polygons,
                           const glm::mat4& clip_from_world, std::vector<std::uint8_t>& out) {
  impl_->rebind();
  impl_->polygons.markVisible(polygons, upsideDown(clip_from_world));
  Image marked;
  readColor(marked);
  impl_->polygons.clearMarks();
  out.resize(marked.rgba.size() / 4);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = marked.rgba[4 * i + 3];
}

void Renderer::readDepth(std::vector<float>& out) {
  const int width = impl_->frame().width();
  const int height = impl_->frame().height();
  out.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  impl_->rebind();
  impl_->gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, out.data());
}

}  // namespace enfilade
