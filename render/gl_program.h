#pragma once

#include <span>
#include <string>

#include "render/gl_functions.h"

namespace enfilade {

/// Compiles and links a vertex and a fragment shader; attribute i of the vertex shader is
/// `attributes[i]`.  The caller deletes it.  Throws Error (kMachine) with the compiler's words.
GLuint createProgram(const GlFunctions& gl, const std::string& vertex, const std::string& fragment,
                     std::span<const char* const> attributes);

}  // namespace enfilade
