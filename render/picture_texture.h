#pragma once

#include <glm/glm.hpp>

#include "render/gl_functions.h"

namespace enfilade {

/// An RGBA8 texture without mip levels that pictures are written into, read to its edge.
struct PictureTexture {
  GLuint name = 0;
  glm::ivec2 size{0};

  /// Binds it to unit 0, which may have had a sampler, with room for `new_size` texels; makes it
  /// first if there is none.  What it held is lost if its size changes.
  void bind(const GlFunctions& gl, const glm::ivec2& new_size, bool smooth);
};

}  // namespace enfilade
