#include <GL/glcorearb.h>
// glcorearb.h first: its function types are skipped once gl.h, which osmesa.h includes, is there.
#include <GL/osmesa.h>

#include <array>

#include "render/gl_context.h"
#include "scene/error.h"

namespace enfilade {
namespace {

class OsMesaContext final : public GlContext {
 public:
  explicit OsMesaContext(int threads) {
    chooseDriverThreads(threads);
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
      destroy();
      throw;
    }
  }

  ~OsMesaContext() override { destroy(); }

  std::string description() const override { return describeDriver(gl_); }

 protected:
  void take() override {
    if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) != GL_TRUE) {
      throw Error(ErrorKind::kMachine, "OpenGL", "OSMesa cannot make its context current");
    }
  }

  void letGo() noexcept override { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

 private:
  static constexpr int kSide = 8;

  void destroy() noexcept {
    letGoIfCurrent();
    OSMesaDestroyContext(context_);
  }

  OSMesaContext context_ = nullptr;
  std::array<std::uint8_t, 4 * kSide * kSide> pixels_{};
};

}  // namespace

std::unique_ptr<GlContext> createOsMesaContext(int threads) {
  return std::make_unique<OsMesaContext>(threads);
}

}  // namespace enfilade
