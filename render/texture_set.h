#pragma once

#include <map>
#include <vector>

#include "render/gl_functions.h"
#include "scene/building.h"

namespace enfilade {

/// The textures of a building, one an image, and the samplers that its materials read them with.
/// The context must be current.
class TextureSet {
 public:
  /// Uploads every image that a material uses, with mip levels.  Throws Error (kMachine).
  TextureSet(const GlFunctions& gl, const Building& building);
  ~TextureSet();
  TextureSet(const TextureSet&) = delete;
  TextureSet& operator=(const TextureSet&) = delete;

  GLuint texture(const Material& material) const { return textures_[material.image]; }
  GLuint sampler(const Material& material);

  /// Has all samplers made so far read `levels` mip levels coarser.
  void setBias(float levels);

 private:
  const GlFunctions& gl_;
  std::vector<GLuint> textures_;  // one an image, 0 where no material uses it
  std::map<std::uint32_t, GLuint> samplers_;
  float bias_ = 0;
};

/// Uploads `image` as level `level` of the bound GL_TEXTURE_2D, RGBA8 as stored.
void uploadLevel(const GlFunctions& gl, int level, const Image& image);

}  // namespace enfilade
