#include "render/gl_functions.h"

#include <string>

#include "scene/error.h"

namespace enfilade {

GlFunctions loadGlFunctions(GlGetProcAddress get_proc_address) {
  GlFunctions gl;
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(  // NOLINT
        get_proc_address(name));
    if (function == nullptr) {
      throw Error(ErrorKind::kMachine, "OpenGL", std::string("has no ") + name);
    }
  };
#define ENFILADE_GL_LOAD(name, upper) load(gl.name, "gl" #name);
  ENFILADE_GL_FUNCTIONS(ENFILADE_GL_LOAD)
#undef ENFILADE_GL_LOAD
  return gl;
}

}  // namespace enfilade
