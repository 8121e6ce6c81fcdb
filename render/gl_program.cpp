#include "render/gl_program.h"

#include <array>

#include "scene/error.h"

namespace enfilade {
namespace {

GLuint compileShader(const GlFunctions& gl, GLenum kind, const std::string& source) {
  const GLuint shader = gl.CreateShader(kind);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  std::array<char, 1024> log{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  throw Error(ErrorKind::kMachine, "OpenGL",
              std::string("a shader does not compile: ") + log.data());
}

}  // namespace

GLuint createProgram(const GlFunctions& gl, const std::string& vertex, const std::string& fragment,
                     std::span<const char* const> attributes) {
  const GLuint program = gl.CreateProgram();
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    gl.BindAttribLocation(program, static_cast<GLuint>(i), attributes[i]);
  }
  // A shader that a program holds lives as long as the program.
  const GLuint vertex_shader = compileShader(gl, GL_VERTEX_SHADER, vertex);
  gl.AttachShader(program, vertex_shader);
  gl.DeleteShader(vertex_shader);
  const GLuint fragment_shader = compileShader(gl, GL_FRAGMENT_SHADER, fragment);
  gl.AttachShader(program, fragment_shader);
  gl.DeleteShader(fragment_shader);
  gl.LinkProgram(program);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return program;
  std::array<char, 1024> log{};
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  throw Error(ErrorKind::kMachine, "OpenGL", std::string("a program does not link: ") + log.data());
}

}  // namespace enfilade
