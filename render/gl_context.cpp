#include "render/gl_context.h"

#include <cstdlib>

namespace enfilade {
namespace {

// OSMesa and Mesa's EGL keep the current context in one place, and each believes that nobody else
// changes it.  So it is ours to know, and one lets go before the other takes over.
thread_local GlContext* current = nullptr;

}  // namespace

void GlContext::makeCurrent() {
  if (current == this) return;
  if (current != nullptr) current->letGo();
  current = nullptr;
  take();
  current = this;
}

void GlContext::letGoIfCurrent() noexcept {
  if (current != this) return;
  letGo();
  current = nullptr;
}

std::string describeDriver(const GlFunctions& gl) {
  const auto text = [&](GLenum name) {
    return std::string(reinterpret_cast<const char*>(gl.GetString(name)));  // NOLINT
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

/// llvmpipe rasterises with LP_NUM_THREADS workers beside the calling thread, which waits for
/// them; with 0 the calling thread does all.  So one thread is 0 workers, and n threads n.
void chooseDriverThreads(int threads) {
  if (threads <= 0) return;
  const int workers = threads == 1 ? 0 : threads;
  setenv("LP_NUM_THREADS", std::to_string(workers).c_str(), 1);
}

const char* glBackendName(GlBackend backend) {
  return backend == GlBackend::kEgl ? "egl" : "osmesa";
}

std::unique_ptr<GlContext> createGlContext(GlBackend backend, int threads) {
  return backend == GlBackend::kEgl ? createEglContext(threads) : createOsMesaContext(threads);
}

}  // namespace enfilade
