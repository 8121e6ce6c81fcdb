#include "render/texture_set.h"

#include "render/mip_chain.h"
#include "scene/error.h"

namespace enfilade {
namespace {

GLint glWrap(Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat:
      return GL_REPEAT;
    case Wrap::kClampToEdge:
      return GL_CLAMP_TO_EDGE;
    case Wrap::kMirroredRepeat:
      return GL_MIRRORED_REPEAT;
  }
  return GL_REPEAT;
}

GLuint uploadWithLevels(const GlFunctions& gl, const Image& image) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  int level = 0;
  const auto upload = [&](const Image& picture) {
    // What is larger than the machine can starts with a smaller level.
    if (picture.width <= most && picture.height <= most) uploadLevel(gl, level++, picture);
  };
  upload(image);
  for (const Image& smaller : mipChain(image)) upload(smaller);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
  return name;
}

}  // namespace

void uploadLevel(const GlFunctions& gl, int level, const Image& image) {
  gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                GL_UNSIGNED_BYTE, image.rgba.data());
}

TextureSet::TextureSet(const GlFunctions& gl, const Building& building) : gl_(gl) {
  textures_.assign(building.images.size(), 0);
  for (const Material& material : building.materials) {
    if (material.image == kNone || textures_[material.image] != 0) continue;
    textures_[material.image] = uploadWithLevels(gl, building.images[material.image].image);
  }
  if (gl.GetError() != GL_NO_ERROR) {
    throw Error(ErrorKind::kMachine, "OpenGL", "has no memory for the textures");
  }
}

TextureSet::~TextureSet() {
  gl_.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
  for (const auto& [key, name] : samplers_) gl_.DeleteSamplers(1, &name);
}

GLuint TextureSet::sampler(const Material& material) {
  const std::uint32_t key = static_cast<std::uint32_t>(material.wrap_s) +
                            4u * static_cast<std::uint32_t>(material.wrap_t) +
                            (material.nearest_filter ? 16u : 0u);
  GLuint& name = samplers_[key];
  if (name == 0) {
    gl_.GenSamplers(1, &name);
    const auto set = [&](GLenum what, GLint value) { gl_.SamplerParameteri(name, what, value); };
    set(GL_TEXTURE_WRAP_S, glWrap(material.wrap_s));
    set(GL_TEXTURE_WRAP_T, glWrap(material.wrap_t));
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    set(GL_TEXTURE_MAG_FILTER, material.nearest_filter ? GL_NEAREST : GL_LINEAR);
  }
  return name;
}

void TextureSet::setBias(float levels) {
  if (levels == bias_) return;
  bias_ = levels;
  for (const auto& [key, name] : samplers_) {
    gl_.SamplerParameterf(name, GL_TEXTURE_LOD_BIAS, levels);
  }
}

}  // namespace enfilade
