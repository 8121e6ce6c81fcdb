#include "render/renderer_shaders.h"

namespace enfilade {
namespace {

// Every interpolated number costs llvmpipe time, so a variant has only those it needs.
const char* const kVertexMain = R"(
uniform mat4 clip_from_world;
in vec3 position;
in vec4 front;
out COLOR v_front;
#ifdef DOUBLE_SIDED
in vec4 back;
out COLOR v_back;
#endif
#ifdef TEXTURED
in vec2 texcoord;
out vec2 v_texcoord;
#endif
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  v_front = COLOR(front);
#ifdef DOUBLE_SIDED
  v_back = COLOR(back);
#endif
#ifdef TEXTURED
  v_texcoord = texcoord;
#endif
}
)";

const char* const kFragmentMain = R"(
in COLOR v_front;
#ifdef DOUBLE_SIDED
in COLOR v_back;
#endif
#ifdef TEXTURED
uniform sampler2D image;
in vec2 v_texcoord;
#endif
#ifdef MASKED
uniform float cutoff;
#endif
out vec4 pixel;
void main() {
#ifdef DOUBLE_SIDED
  COLOR color = gl_FrontFacing ? v_front : v_back;
#else
  COLOR color = v_front;
#endif
#ifdef TEXTURED
  color *= COLOR(texture(image, v_texcoord));
#endif
#ifdef OPAQUE
  pixel = vec4(color, 1.0);
#endif
#ifdef MASKED
  if (color.a < cutoff) discard;
  pixel = vec4(color.rgb, 1.0);
#endif
#ifdef BLENDED
  pixel = color;
#endif
}
)";

std::string header(const ProgramVariant& variant) {
  std::string text = "#version 330 core\n";
  if (variant.textured) text += "#define TEXTURED\n";
  if (variant.double_sided) text += "#define DOUBLE_SIDED\n";
  switch (variant.alpha_mode) {
    case AlphaMode::kOpaque:
      return text + "#define OPAQUE\n#define COLOR vec3\n";
    case AlphaMode::kMask:
      return text + "#define MASKED\n#define COLOR vec4\n";
    case AlphaMode::kBlend:
      return text + "#define BLENDED\n#define COLOR vec4\n";
  }
  return text;
}

}  // namespace

std::string vertexShader(const ProgramVariant& variant) { return header(variant) + kVertexMain; }

std::string fragmentShader(const ProgramVariant& variant) {
  return header(variant) + kFragmentMain;
}

const char* const kPolygonVertexShader = R"(#version 330 core
uniform mat4 clip_from_world;
in vec3 position;
in vec2 texcoord;
out vec2 v_texcoord;
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  v_texcoord = texcoord;
}
)";

// Row 0 of the framebuffer is the top row (see renderer.cpp), as it is of the picture.
const char* const kScreenPolygonFragmentShader = R"(#version 330 core
uniform sampler2D image;
out vec4 pixel;
void main() {
  pixel = texelFetch(image, ivec2(gl_FragCoord.xy), 0);
  if (pixel.a == 0.0) discard;
  pixel.a = 1.0;
}
)";

const char* const kTexturedPolygonFragmentShader = R"(#version 330 core
uniform sampler2D image;
in vec2 v_texcoord;
out vec4 pixel;
void main() { pixel = vec4(texture(image, v_texcoord).rgb, 1.0); }
)";

const char* const kMarkFragmentShader = R"(#version 330 core
uniform float mark;
out vec4 pixel;
void main() { pixel = vec4(mark); }
)";

}  // namespace enfilade
