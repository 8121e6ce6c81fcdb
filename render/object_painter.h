#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "render/draw_list.h"
#include "render/gl_functions.h"
#include "render/renderer.h"
#include "render/renderer_shaders.h"
#include "render/texture_set.h"
#include "render/triangle_sieve.h"
#include "render/world_geometry.h"
#include "scene/building.h"

namespace enfilade {

/// Draws a building's objects, under the depth test that it finds.  The context must be current and
/// the framebuffer bound.
class ObjectPainter {
 public:
  /// Uploads the building.  Throws Error (kMachine).
  ObjectPainter(const GlFunctions& gl, const Building& building);
  ~ObjectPainter();
  ObjectPainter(const ObjectPainter&) = delete;
  ObjectPainter& operator=(const ObjectPainter&) = delete;

  /// See Renderer::draw.
  DrawCounts draw(std::span<const std::uint32_t> objects, const glm::vec3& eye,
                  const SieveView& view);

  /// Whether triangles that cover no pixel are left out before OpenGL is asked: so from the start.
  void setTextureBias(float levels) { textures_.setBias(levels); }  ///< see Renderer
  void setSifting(bool sifting) { sifting_ = sifting; }

 private:
  ObjectPainter(const GlFunctions& gl, const Building& building, const WorldGeometry& world);

  /// What must change between two objects' draw calls, and nothing else does.
  struct State {
    ProgramVariant variant;
    GLuint texture = 0;
    GLuint sampler = 0;
    float cutoff = 0;

    bool operator==(const State& other) const = default;
  };
  struct Program {
    GLuint name = 0;
    GLint clip_from_world = -1;
    GLint cutoff = -1;
    bool has_matrix = false;  // of the call at hand
  };

  void upload(const WorldGeometry& world);
  State stateOf(const Material& material, bool textured);
  void chooseStates(const Building& building);
  Program& program(const ProgramVariant& variant);
  void setState(std::uint32_t from, std::uint32_t to);
  void sift(std::span<const std::uint32_t> objects, const SieveView& view);
  void drawRuns(std::span<const std::uint32_t> objects, DrawCounts& counts);
  void drawBlended(const glm::vec3& eye, DrawCounts& counts);

  const GlFunctions& gl_;
  TextureSet textures_;
  std::array<Program, kProgramVariants> programs_;
  GLuint vertex_array_ = 0;
  GLuint buffers_[3] = {0, 0, 0};  // vertices, indices, the indices that the sieve leaves

  std::vector<IndexRange> ranges_;  // one an object
  TriangleSieve sieve_;
  bool sifting_ = true;
  std::vector<glm::vec3> centers_;       // of an object's box
  std::vector<std::uint32_t> state_of_;  // one an object: index in states_
  std::vector<State> states_;            // no two equal

  // Of the call at hand, kept for their memory.
  glm::mat4 clip_from_world_{1};
  std::vector<std::uint32_t> opaque_;
  std::vector<std::uint32_t> blended_;
  std::vector<SieveObject> to_sift_;
  DrawList list_;
};

}  // namespace enfilade
