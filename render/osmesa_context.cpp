#include <GL/glcorearb.h>
// glcorearb.h first: its function types are skipped once gl.h, which osmesa.h includes, is there.
#include <GL/osmesa.h>

#include <array>
#include <cstdlib>

#include "render/gl_context.h"
#include "scene/error.h"

namespace enfilade {
namespace {

class OsMesaContext final : public GlContext {
 public:
  explicit OsMesaContext(int threads) {
    chooseThreads(threads);
    // We draw into framebuffers of our own, so the context's needs no depth and hardly a pixel.
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (context_ == nullptr) {
      throw Error(ErrorKind::kMachine, "OpenGL", "OSMesa cannot create a 3.3 core context");
    }
    try {
      makeCurrent();
      gl_ = loadGlFunctions(&OSMesaGetProcAddress);
    } catch (...) {
      OSMesaDestroyContext(context_);
      throw;
    }
  }

  ~OsMesaContext() override { OSMesaDestroyContext(context_); }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  void makeCurrent() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) != GL_TRUE) {
      throw Error(ErrorKind::kMachine, "OpenGL", "OSMesa cannot make its context current");
    }
  }

  std::string description() const override {
    const auto text = [&](GLenum name) {
      return std::string(reinterpret_cast<const char*>(gl_.GetString(name)));
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  }

 private:
  static constexpr int kSide = 8;

  /// llvmpipe rasterises with LP_NUM_THREADS workers beside the calling thread, which waits for
  /// them; with 0 the calling thread does all.  So one thread is 0 workers, and n threads n.
  static void chooseThreads(int threads) {
    if (threads <= 0) return;
    const int workers = threads == 1 ? 0 : threads;
    setenv("LP_NUM_THREADS", std::to_string(workers).c_str(), 1);
  }

  OSMesaContext context_ = nullptr;
  std::array<std::uint8_t, 4 * kSide * kSide> pixels_{};
};

}  // namespace

std::unique_ptr<GlContext> createOsMesaContext(int threads) {
  return std::make_unique<OsMesaContext>(threads);
}

}  // namespace enfilade
