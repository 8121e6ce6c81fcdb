#include "render/egl_system.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "scene/error.h"

namespace enfilade {
namespace {

struct NamedDisplay {
  std::string name;
  EGLDisplay display;
};

[[noreturn]] void fail(const std::string& reason) {
  throw Error(ErrorKind::kMachine, "EGL", reason + "; --gl osmesa draws without it");
}

bool holdsWord(const char* words, const std::string& wanted) {
  std::istringstream stream(words == nullptr ? "" : words);
  for (std::string word; stream >> word;) {
    if (word == wanted) return true;
  }
  return false;
}

/// Opened when it is asked for, not linked: a program that is linked with a library does not start
/// where that is missing, and OSMesa needs none of it.
EglFunctions loadEgl() {
  void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) fail("libEGL.so.1 cannot be opened (apt-get install libegl1)");
  EglFunctions egl;
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(  // NOLINT
        dlsym(library, name));
    if (function == nullptr) fail(std::string("libEGL.so.1 has no ") + name);
  };
#define ENFILADE_EGL_LOAD(name, upper) load(egl.name, "egl" #name);
  ENFILADE_EGL_FUNCTIONS(ENFILADE_EGL_LOAD)
#undef ENFILADE_EGL_LOAD
  return egl;
}

template <typename Function>
Function extension(const EglFunctions& egl, const char* name) {
  return reinterpret_cast<Function>(egl.GetProcAddress(name));  // NOLINT
}

/// A display for each device that EGL lists, those that are software apart.
void addDevices(const EglFunctions& egl, std::vector<NamedDisplay>& gpus,
                std::vector<NamedDisplay>& software) {
  const auto query = extension<PFNEGLQUERYDEVICESEXTPROC>(egl, "eglQueryDevicesEXT");
  const auto text = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl, "eglQueryDeviceStringEXT");
  const auto open = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl, "eglGetPlatformDisplayEXT");
  if (!query || !text || !open || !egl.has(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) return;
  constexpr EGLint kMost = 32;
  EGLDeviceEXT devices[kMost] = {};
  EGLint count = 0;
  if (query(kMost, devices, &count) != EGL_TRUE) return;
  for (EGLint i = 0; i < count; ++i) {
    const bool is_software =
        holdsWord(text(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
    (is_software ? software : gpus)
        .push_back(
            {fmt::format("device {}", i), open(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)});
  }
}

/// All displays worth a try, the best first.
std::vector<NamedDisplay> displays(const EglFunctions& egl) {
  std::vector<NamedDisplay> all, software;
  addDevices(egl, all, software);
  const auto open = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl, "eglGetPlatformDisplayEXT");
  if (open != nullptr && egl.has(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    all.push_back({"surfaceless", open(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)});
  }
  all.insert(all.end(), software.begin(), software.end());
  all.push_back({"default display", egl.GetDisplay(EGL_DEFAULT_DISPLAY)});
  return all;
}

std::string failureOf(const EglFunctions& egl, const char* call) {
  return fmt::format("{} fails with 0x{:04x}", call, egl.GetError());
}

/// Chooses how `system`'s display makes contexts.  `failure` is what it lacks when it is false.
bool configure(EglSystem& system, std::string& failure) {
  const EglFunctions& egl = system.egl;
  if (egl.Initialize(system.display, nullptr, nullptr) != EGL_TRUE) {
    failure = failureOf(egl, "eglInitialize");
    return false;
  }
  system.surfaceless = egl.has(system.display, "EGL_KHR_surfaceless_context");
  // We draw into framebuffers of our own, so that of the configuration matters only without that.
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                           system.surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_NONE};
  EGLint found = 0;
  if (egl.ChooseConfig(system.display, wanted, &system.config, 1, &found) == EGL_TRUE &&
      found > 0) {
    return true;
  }
  system.config = EGL_NO_CONFIG_KHR;
  failure = "has no configuration for OpenGL";
  return system.surfaceless && egl.has(system.display, "EGL_KHR_no_config_context");
}

/// A system with the first display that a context can be had of.
EglSystem findSystem() {
  EglSystem system;
  system.egl = loadEgl();
  std::string failures;
  for (const auto& [name, display] : displays(system.egl)) {
    system.display = display;
    std::string failure = "is not there";
    EglHandles handles;
    if (display != EGL_NO_DISPLAY && configure(system, failure) &&
        system.create(handles, failure)) {
      system.destroy(handles);
      return system;
    }
    failures += (failures.empty() ? "" : ", ") + name + ": " + failure;
  }
  fail("no display gives an OpenGL 3.3 core context (" + failures + ")");
}

}  // namespace

bool EglFunctions::has(EGLDisplay display, const std::string& name) const {
  return holdsWord(QueryString(display, EGL_EXTENSIONS), name);
}

bool EglSystem::create(EglHandles& handles, std::string& failure) const {
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  // Which API is meant is a thread's own, and OpenGL ES at first.
  if (egl.BindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    failure = "knows no OpenGL";
    return false;
  }
  handles.context = egl.CreateContext(display, config, EGL_NO_CONTEXT, version);
  if (handles.context == EGL_NO_CONTEXT) {
    failure = failureOf(egl, "eglCreateContext");
    return false;
  }
  if (surfaceless) return true;
  const EGLint size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
  handles.surface = egl.CreatePbufferSurface(display, config, size);
  if (handles.surface != EGL_NO_SURFACE) return true;
  failure = failureOf(egl, "eglCreatePbufferSurface");
  destroy(handles);
  return false;
}

bool EglSystem::makeCurrent(const EglHandles& handles) const {
  return egl.BindAPI(EGL_OPENGL_API) == EGL_TRUE &&
         egl.MakeCurrent(display, handles.surface, handles.surface, handles.context) == EGL_TRUE;
}

void EglSystem::destroy(EglHandles& handles) const {
  if (handles.surface != EGL_NO_SURFACE) egl.DestroySurface(display, handles.surface);
  if (handles.context != EGL_NO_CONTEXT) egl.DestroyContext(display, handles.context);
  handles = {};
}

const EglSystem& eglSystem() {
  static const EglSystem system = findSystem();
  return system;
}

}  // namespace enfilade
