#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "render/draw_list.h"
#include "render/frame_buffer.h"
#include "render/gl_program.h"
#include "render/polygon_painter.h"
#include "render/renderer_shaders.h"
#include "render/texture_set.h"
#include "render/world_geometry.h"
#include "scene/error.h"

namespace enfilade {
namespace {

/// What must change between two objects' draw calls, and nothing else does.
struct DrawState {
  ProgramVariant variant;
  GLuint texture = 0;
  GLuint sampler = 0;
  float cutoff = 0;

  bool operator==(const DrawState& other) const noexcept {
    return variant.index() == other.variant.index() && texture == other.texture &&
           sampler == other.sampler && cutoff == other.cutoff;
  }
};

struct Program {
  GLuint name = 0;
  GLint clip_from_world = -1;
  GLint cutoff = -1;
  bool has_matrix = false;  // of the call at hand
};

/// Window rows grow upwards in OpenGL.  We draw upside down, so that row 0 is the top row and
/// reading back needs no turning; what was counter-clockwise is clockwise then.
glm::mat4 upsideDown(const glm::mat4& clip_from_world) {
  glm::mat4 m = clip_from_world;
  for (int column = 0; column < 4; ++column) m[column][1] = -m[column][1];
  return m;
}

}  // namespace

struct Renderer::Impl {
  Impl(GlContext& gl_context, const Building& building);
  ~Impl();

  void upload(const WorldGeometry& world);
  void chooseStates(const Building& building);
  DrawState stateOf(const Building& building, const Object& object);
  void begin(int width, int height);
  DrawCounts draw(std::span<const std::uint32_t> objects, const View& view);
  void drawBlended(const View& view, DrawCounts& counts);
  void drawRuns(std::span<const std::uint32_t> objects, DrawCounts& counts);
  void setState(std::uint32_t from, std::uint32_t to);
  Program& program(const ProgramVariant& variant);

  GlContext& context;
  const GlFunctions& gl;
  FrameBuffer frame;
  TextureSet textures;
  PolygonPainter painter;
  std::array<Program, kProgramVariants> programs;
  GLuint vertex_array = 0;
  GLuint buffers[2] = {0, 0};  // vertices, indices

  std::vector<IndexRange> ranges;             // one an object
  std::vector<glm::vec3> centers;             // of an object's box
  std::vector<std::uint32_t> state_of;        // one an object: index in `states`
  std::vector<DrawState> states;              // no two equal
  std::vector<std::uint32_t> opaque_objects;  // of the call at hand, kept for their memory
  std::vector<std::uint32_t> blended_objects;
  DrawList list;
  glm::mat4 clip_from_world{1};  // of the call at hand, upside down
};

Renderer::Impl::Impl(GlContext& gl_context, const Building& building)
    : context((gl_context.makeCurrent(), gl_context)),
      gl(gl_context.gl()),
      frame(gl),
      textures(gl, building),
      painter(gl) {
  gl.GenVertexArrays(1, &vertex_array);
  gl.GenBuffers(2, buffers);
  WorldGeometry world = worldGeometry(building);
  upload(world);
  ranges = std::move(world.objects);
  for (const Object& object : building.objects) {
    centers.push_back(worldBounds(building, object).center());
  }
  chooseStates(building);
}

Renderer::Impl::~Impl() {
  context.makeCurrent();
  for (const Program& p : programs) gl.DeleteProgram(p.name);
  gl.DeleteVertexArrays(1, &vertex_array);
  gl.DeleteBuffers(2, buffers);
}

void Renderer::Impl::upload(const WorldGeometry& world) {
  gl.BindVertexArray(vertex_array);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(world.vertices.size() * sizeof(WorldVertex)),
                world.vertices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(world.indices.size() * sizeof(std::uint32_t)),
                world.indices.data(), GL_STATIC_DRAW);
  const auto attribute = [&](GLuint i, int size, GLenum type, GLboolean normalised,
                             std::size_t offset) {
    gl.EnableVertexAttribArray(i);
    gl.VertexAttribPointer(i, size, type, normalised, sizeof(WorldVertex),
                           reinterpret_cast<const void*>(offset));  // NOLINT
  };
  attribute(0, 3, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, position));
  attribute(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(WorldVertex, front));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(WorldVertex, back));
  attribute(3, 2, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, texcoord));
  if (gl.GetError() != GL_NO_ERROR) {
    throw Error(ErrorKind::kMachine, "OpenGL", "has no memory for the geometry");
  }
}

DrawState Renderer::Impl::stateOf(const Building& building, const Object& object) {
  const Material& material = building.materialOf(object);
  const VertexArrays& vertices = building.vertex_arrays[building.meshOf(object).vertices];
  DrawState state;
  state.variant.textured = material.image != kNone && !vertices.texcoords.empty();
  state.variant.double_sided = material.double_sided;
  state.variant.alpha_mode = material.alpha_mode;
  if (state.variant.textured) {
    state.texture = textures.texture(material);
    state.sampler = textures.sampler(material);
  }
  if (material.alpha_mode == AlphaMode::kMask) state.cutoff = material.alpha_cutoff;
  return state;
}

void Renderer::Impl::chooseStates(const Building& building) {
  for (const Object& object : building.objects) {
    const DrawState state = stateOf(building, object);
    const auto found = std::find(states.begin(), states.end(), state);
    state_of.push_back(static_cast<std::uint32_t>(found - states.begin()));
    if (found == states.end()) states.push_back(state);
  }
}

Program& Renderer::Impl::program(const ProgramVariant& variant) {
  Program& p = programs[variant.index()];
  if (p.name == 0) {
    p.name = createProgram(gl, vertexShader(variant), fragmentShader(variant), kVertexAttributes);
    p.clip_from_world = gl.GetUniformLocation(p.name, "clip_from_world");
    p.cutoff = gl.GetUniformLocation(p.name, "cutoff");
  }
  return p;
}

void Renderer::Impl::begin(int width, int height) {
  context.makeCurrent();
  frame.bind(width, height);
  painter.begin();
  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);  // of coplanar faces the first drawn stays
  gl.DepthMask(GL_TRUE);
  gl.FrontFace(GL_CW);  // as it looks upside down
  gl.CullFace(GL_BACK);
  gl.ClearColor(kSkyColor[0] / 255.0f, kSkyColor[1] / 255.0f, kSkyColor[2] / 255.0f, 1.0f);
  gl.ClearDepth(1.0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::Impl::setState(std::uint32_t from, std::uint32_t to) {
  // Each change costs the driver some microseconds, so only what differs is set.
  static constexpr DrawState kNothing;
  const DrawState& old = from == kNone ? kNothing : states[from];
  const DrawState& state = states[to];
  Program& p = program(state.variant);
  if (from == kNone || old.variant.index() != state.variant.index()) gl.UseProgram(p.name);
  if (!p.has_matrix) gl.UniformMatrix4fv(p.clip_from_world, 1, GL_FALSE, &clip_from_world[0][0]);
  p.has_matrix = true;
  if (p.cutoff >= 0) gl.Uniform1f(p.cutoff, state.cutoff);
  if (state.variant.textured) {
    if (old.texture != state.texture) gl.BindTexture(GL_TEXTURE_2D, state.texture);
    if (old.sampler != state.sampler) gl.BindSampler(0, state.sampler);
  }
  if (from != kNone && old.variant.double_sided == state.variant.double_sided) return;
  if (state.variant.double_sided) {
    gl.Disable(GL_CULL_FACE);
  } else {
    gl.Enable(GL_CULL_FACE);
  }
}

void Renderer::Impl::drawRuns(std::span<const std::uint32_t> objects, DrawCounts& counts) {
  std::uint32_t current = kNone;
  const auto flush = [&] {
    if (list.empty()) return;
    list.draw(gl);
    ++counts.draw_calls;
  };
  for (const std::uint32_t o : objects) {
    if (state_of[o] != current) {
      flush();
      setState(current, state_of[o]);
      current = state_of[o];
    }
    list.add(ranges[o].first, ranges[o].count);
    counts.triangles += ranges[o].count / 3;
  }
  flush();
}

void Renderer::Impl::drawBlended(const View& view, DrawCounts& counts) {
  if (blended_objects.empty()) return;
  const auto distance = [&](std::uint32_t o) {
    const glm::vec3 d = centers[o] - view.eye;
    return glm::dot(d, d);
  };
  std::stable_sort(blended_objects.begin(), blended_objects.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return distance(a) > distance(b); });
  gl.Enable(GL_BLEND);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  gl.DepthMask(GL_FALSE);
  drawRuns(blended_objects, counts);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

DrawCounts Renderer::Impl::draw(std::span<const std::uint32_t> objects, const View& view) {
  assert(std::is_sorted(objects.begin(), objects.end()));
  clip_from_world = upsideDown(view.clip_from_world);
  for (Program& p : programs) p.has_matrix = false;
  opaque_objects.clear();
  blended_objects.clear();
  for (const std::uint32_t o : objects) {
    const bool blended = states[state_of[o]].variant.alpha_mode == AlphaMode::kBlend;
    (blended ? blended_objects : opaque_objects).push_back(o);
  }
  gl.BindVertexArray(vertex_array);
  gl.ActiveTexture(GL_TEXTURE0);
  DrawCounts counts;
  drawRuns(opaque_objects, counts);
  drawBlended(view, counts);
  gl.Disable(GL_CULL_FACE);
  return counts;
}

Renderer::Renderer(GlContext& context, const Building& building)
    : impl_(std::make_unique<Impl>(context, building)) {}

Renderer::~Renderer() = default;

void Renderer::begin(int width, int height) { impl_->begin(width, height); }

DrawCounts Renderer::draw(std::span<const std::uint32_t> objects, const View& view) {
  return impl_->draw(objects, view);
}

void Renderer::drawScreenPolygons(std::span<const ScreenPolygon> polygons, const Image& picture,
                                  const glm::ivec4& region, const glm::mat4& clip_from_world) {
  assert(picture.width == impl_->frame.width() && picture.height == impl_->frame.height());
  impl_->painter.drawScreenPolygons(polygons, picture, region, upsideDown(clip_from_world));
}

void Renderer::drawTexturedPolygon(std::span<const glm::vec3> polygon,
                                   std::span<const glm::vec2> texcoords, const Image& texture,
                                   const glm::mat4& clip_from_world) {
  impl_->painter.drawTexturedPolygon(polygon, texcoords, texture, upsideDown(clip_from_world));
}

void Renderer::finish() { impl_->gl.Finish(); }

void Renderer::readColor(Image& out) {
  out.width = impl_->frame.width();
  out.height = impl_->frame.height();
  out.rgba.resize(4 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  impl_->gl.ReadPixels(0, 0, out.width, out.height, GL_RGBA, GL_UNSIGNED_BYTE, out.rgba.data());
}

void Renderer::readDepth(std::vector<float>& out) {
  const int width = impl_->frame.width();
  const int height = impl_->frame.height();
  out.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  impl_->gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, out.data());
}

}  // namespace enfilade
