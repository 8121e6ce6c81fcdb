#include <fmt/format.h>

#include "render/egl_system.h"
#include "render/gl_context.h"
#include "scene/error.h"

namespace enfilade {
namespace {

GlProc eglProc(const char* name) { return eglSystem().egl.GetProcAddress(name); }

[[noreturn]] void fail(const std::string& reason) {
  throw Error(ErrorKind::kMachine, "EGL", reason + "; --gl osmesa draws without it");
}

class EglContext final : public GlContext {
 public:
  EglContext() : system_(eglSystem()) {
    std::string failure;
    if (!system_.create(handles_, failure)) fail(failure);
    try {
      makeCurrent();
      gl_ = loadGlFunctions(&eglProc);
    } catch (...) {
      destroy();
      throw;
    }
  }

  ~EglContext() override { destroy(); }

  std::string description() const override { return describeDriver(gl_) + " by EGL"; }

 protected:
  void take() override {
    if (system_.makeCurrent(handles_)) return;
    fail(fmt::format("cannot make its context current (0x{:04x})", system_.egl.GetError()));
  }

  void letGo() noexcept override { system_.makeCurrent({}); }

 private:
  void destroy() noexcept {
    letGoIfCurrent();
    system_.destroy(handles_);
  }

  const EglSystem& system_;
  EglHandles handles_;
};

}  // namespace

std::unique_ptr<GlContext> createEglContext(int threads) {
  chooseDriverThreads(threads);
  return std::make_unique<EglContext>();
}

}  // namespace enfilade
