#include "render/object_painter.h"

#include <algorithm>
#include <cassert>

#include "render/gl_program.h"
#include "scene/error.h"

namespace enfilade {

ObjectPainter::ObjectPainter(const GlFunctions& gl, const Building& building)
    : ObjectPainter(gl, building, worldGeometry(building)) {}

ObjectPainter::ObjectPainter(const GlFunctions& gl, const Building& building,
                             const WorldGeometry& world)
    : gl_(gl), textures_(gl, building), ranges_(world.objects), sieve_(world) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(3, buffers_);
  upload(world);
  for (const Object& object : building.objects) {
    centers_.push_back(worldBounds(building, object).center());
  }
  chooseStates(building);
}

ObjectPainter::~ObjectPainter() {
  for (const Program& p : programs_) gl_.DeleteProgram(p.name);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(3, buffers_);
}

void ObjectPainter::upload(const WorldGeometry& world) {
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.BufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(world.vertices.size() * sizeof(WorldVertex)),
                 world.vertices.data(), GL_STATIC_DRAW);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(world.indices.size() * sizeof(std::uint32_t)),
                 world.indices.data(), GL_STATIC_DRAW);
  const auto attribute = [&](GLuint i, int size, GLenum type, GLboolean normalised,
                             std::size_t offset) {
    gl_.EnableVertexAttribArray(i);
    gl_.VertexAttribPointer(i, size, type, normalised, sizeof(WorldVertex),
                            reinterpret_cast<const void*>(offset));  // NOLINT
  };
  attribute(0, 3, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, position));
  attribute(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(WorldVertex, front));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(WorldVertex, back));
  attribute(3, 2, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, texcoord));
  if (gl_.GetError() != GL_NO_ERROR) {
    throw Error(ErrorKind::kMachine, "OpenGL", "has no memory for the geometry");
  }
}

ObjectPainter::State ObjectPainter::stateOf(const Material& material, bool textured) {
  State state;
  state.variant = {textured, material.double_sided, material.alpha_mode};
  if (textured) {
    state.texture = textures_.texture(material);
    state.sampler = textures_.sampler(material);
  }
  if (material.alpha_mode == AlphaMode::kMask) state.cutoff = material.alpha_cutoff;
  return state;
}

void ObjectPainter::chooseStates(const Building& building) {
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;  // by material, textured or not
  for (const Object& object : building.objects) {
    const Mesh& mesh = building.meshOf(object);
    const Material& material = building.materials[mesh.material];
    const bool textured =
        material.image != kNone && !building.vertex_arrays[mesh.vertices].texcoords.empty();
    const auto [entry, is_new] = known.try_emplace({mesh.material, textured}, 0u);
    if (is_new) {
      const State state = stateOf(material, textured);
      const auto found = std::find(states_.begin(), states_.end(), state);
      entry->second = static_cast<std::uint32_t>(found - states_.begin());
      if (found == states_.end()) states_.push_back(state);
    }
    state_of_.push_back(entry->second);
  }
}

ObjectPainter::Program& ObjectPainter::program(const ProgramVariant& variant) {
  Program& p = programs_[variant.index()];
  if (p.name == 0) {
    p.name = createProgram(gl_, vertexShader(variant), fragmentShader(variant), kVertexAttributes);
    p.clip_from_world = gl_.GetUniformLocation(p.name, "clip_from_world");
    p.cutoff = gl_.GetUniformLocation(p.name, "cutoff");
  }
  return p;
}

void ObjectPainter::setState(std::uint32_t from, std::uint32_t to) {
  // Each change costs the driver some microseconds, so only what differs is set.
  static constexpr State kNothing;
  const State& old = from == kNone ? kNothing : states_[from];
  const State& state = states_[to];
  Program& p = program(state.variant);
  if (from == kNone || old.variant != state.variant) gl_.UseProgram(p.name);
  if (!p.has_matrix) gl_.UniformMatrix4fv(p.clip_from_world, 1, GL_FALSE, &clip_from_world_[0][0]);
  p.has_matrix = true;
  if (p.cutoff >= 0) gl_.Uniform1f(p.cutoff, state.cutoff);
  if (state.variant.textured) {
    if (old.texture != state.texture) gl_.BindTexture(GL_TEXTURE_2D, state.texture);
    if (old.sampler != state.sampler) gl_.BindSampler(0, state.sampler);
  }
  if (from != kNone && old.variant.double_sided == state.variant.double_sided) return;
  if (state.variant.double_sided) {
    gl_.Disable(GL_CULL_FACE);
  } else {
    gl_.Enable(GL_CULL_FACE);
  }
}

void ObjectPainter::drawRuns(std::span<const std::uint32_t> objects, DrawCounts& counts) {
  std::uint32_t current = kNone;
  const auto flush = [&] {
    if (list_.empty()) return;
    list_.draw(gl_);
    ++counts.draw_calls;
  };
  for (const std::uint32_t o : objects) {
    const IndexRange& range = sifting_ ? sieve_.range(o) : ranges_[o];
    if (range.count == 0) continue;
    if (state_of_[o] != current) {
      flush();
      setState(current, state_of_[o]);
      current = state_of_[o];
    }
    list_.add(range.first, range.count);
    counts.triangles += range.count / 3;
  }
  flush();
}

void ObjectPainter::drawBlended(const glm::vec3& eye, DrawCounts& counts) {
  if (blended_.empty()) return;
  const auto distance = [&](std::uint32_t o) {
    const glm::vec3 d = centers_[o] - eye;
    return glm::dot(d, d);
  };
  std::stable_sort(blended_.begin(), blended_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return distance(a) > distance(b); });
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  gl_.DepthMask(GL_FALSE);
  drawRuns(blended_, counts);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
}

void ObjectPainter::sift(std::span<const std::uint32_t> objects, const SieveView& view) {
  if (!sifting_) {
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    return;
  }
  to_sift_.clear();
  for (const std::uint32_t o : objects) {
    const ProgramVariant& variant = states_[state_of_[o]].variant;
    to_sift_.push_back({o, variant.double_sided, variant.alpha_mode == AlphaMode::kOpaque});
  }
  sieve_.sift(to_sift_, view);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sieve_.indices().size_bytes()),
                 sieve_.indices().data(), GL_STREAM_DRAW);
}

DrawCounts ObjectPainter::draw(std::span<const std::uint32_t> objects, const glm::vec3& eye,
                               const SieveView& view) {
  assert(std::is_sorted(objects.begin(), objects.end()));
  clip_from_world_ = view.clip_from_world;
  for (Program& p : programs_) p.has_matrix = false;
  opaque_.clear();
  blended_.clear();
  for (const std::uint32_t o : objects) {
    const bool blended = states_[state_of_[o]].variant.alpha_mode == AlphaMode::kBlend;
    (blended ? blended_ : opaque_).push_back(o);
  }
  gl_.BindVertexArray(vertex_array_);
  gl_.ActiveTexture(GL_TEXTURE0);
  sift(objects, view);
  DrawCounts counts;
  drawRuns(opaque_, counts);
  drawBlended(eye, counts);
  gl_.Disable(GL_CULL_FACE);
  return counts;
}

}  // namespace enfilade
