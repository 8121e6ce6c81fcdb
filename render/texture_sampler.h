#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// An image and its mip levels (mip_chain.h), read as OpenGL does: GL_LINEAR_MIPMAP_LINEAR when it
/// is made smaller; linear, or nearest, when larger.
class TextureSampler {
 public:
  /// Keeps a reference to `image`.
  explicit TextureSampler(const Image& image);

  glm::vec2 size() const noexcept { return size_; }  ///< [texels] of the image itself

  /// RGBA, 0…255.  `level_of_detail`: log2 of the texels across a pixel.
  glm::vec4 sample(const Material& material, const glm::vec2& texcoord,
                   float level_of_detail) const noexcept;

 private:
  glm::vec2 size_;
  const Image& image_;
  std::vector<Image> smaller_;
};

}  // namespace enfilade
