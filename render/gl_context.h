#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "render/gl_functions.h"

namespace enfilade {

/// An OpenGL 3.3 core context.  One thread at a time; current from construction on.
class GlContext {
 public:
  GlContext() = default;
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes it the calling thread's context; whichever was lets go first.  Throws Error (kMachine).
  void makeCurrent();
  virtual std::string description() const = 0;  ///< renderer and version, for reports

  const GlFunctions& gl() const noexcept { return gl_; }

 protected:
  virtual void take() = 0;            ///< becomes the calling thread's context
  virtual void letGo() noexcept = 0;  ///< leaves the calling thread without one
  void letGoIfCurrent() noexcept;     ///< for destructors, and constructors that throw

  GlFunctions gl_;
};

/// The driver's renderer and version.
std::string describeDriver(const GlFunctions& gl);

/// Has software drivers (llvmpipe) draw with `threads` threads, 0: as many as the machine has.
/// The first context of a process decides.
void chooseDriverThreads(int threads);

/// What draws without a window.
enum class GlBackend : std::uint8_t {
  kOsMesa,  ///< Mesa's llvmpipe: on the processor, the same pixels on every machine
  kEgl,     ///< the machine's GPU, with or without a display; where there is none, what EGL has
};

/// "osmesa" or "egl": as on the command line and in a house's record.
const char* glBackendName(GlBackend backend);

/// A context of `backend`.  `threads`: that software draws with, 0: as many as the machine has; the
/// first context of a process decides.  Throws Error (kMachine) when the machine cannot.
std::unique_ptr<GlContext> createGlContext(GlBackend backend, int threads = 0);

std::unique_ptr<GlContext> createOsMesaContext(int threads = 0);
std::unique_ptr<GlContext> createEglContext(int threads = 0);

}  // namespace enfilade
