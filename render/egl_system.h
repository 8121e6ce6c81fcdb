#pragma once

#define EGL_NO_PLATFORM_SPECIFIC_TYPES  // no X11: nothing here is shown
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>

/// The functions of EGL that we use: X(name without egl, the name in capitals as egl.h has it).
#define ENFILADE_EGL_FUNCTIONS(X)               \
  X(BindAPI, BINDAPI)                           \
  X(ChooseConfig, CHOOSECONFIG)                 \
  X(CreateContext, CREATECONTEXT)               \
  X(CreatePbufferSurface, CREATEPBUFFERSURFACE) \
  X(DestroyContext, DESTROYCONTEXT)             \
  X(DestroySurface, DESTROYSURFACE)             \
  X(GetDisplay, GETDISPLAY)                     \
  X(GetError, GETERROR)                         \
  X(GetProcAddress, GETPROCADDRESS)             \
  X(Initialize, INITIALIZE)                     \
  X(MakeCurrent, MAKECURRENT)                   \
  X(QueryString, QUERYSTRING)

namespace enfilade {

struct EglFunctions {
#define ENFILADE_EGL_MEMBER(name, upper) PFNEGL##upper##PROC name = nullptr;
  ENFILADE_EGL_FUNCTIONS(ENFILADE_EGL_MEMBER)
#undef ENFILADE_EGL_MEMBER

  /// Whether the extensions of `display` (EGL_NO_DISPLAY: of the client) have `name`.
  bool has(EGLDisplay display, const std::string& name) const;
};

/// A context and what it draws into until a framebuffer is bound: nothing, or a small surface.
struct EglHandles {
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
};

/// EGL with one display that gives OpenGL 3.3 core contexts without a window.
struct EglSystem {
  EglFunctions egl;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;  ///< EGL_NO_CONFIG_KHR where the display needs none
  bool surfaceless = false;    ///< a context can be current without a surface

  /// Makes a context.  `failure` is what failed when it is false.
  bool create(EglHandles& handles, std::string& failure) const;
  bool makeCurrent(const EglHandles& handles) const;
  void destroy(EglHandles& handles) const;
};

/// The process's own, found when it is first asked for: a GPU where there is one, otherwise what
/// draws in software.  It lives as long as the process, as displays are shared by all who ask for
/// them.  Throws Error (kMachine) that says what each display lacks.
const EglSystem& eglSystem();

}  // namespace enfilade
