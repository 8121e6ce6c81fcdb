#include "render/gl_context.h"

#include <cstdlib>

namespace enfilade {

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

}  // namespace enfilade
