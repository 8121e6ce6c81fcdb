#pragma once

#include <memory>
#include <string>

#include "render/gl_functions.h"

namespace enfilade {

/// An OpenGL 3.3 core context.  One thread at a time; current from construction on.
class GlContext {
 public:
  virtual ~GlContext() = default;
  virtual void makeCurrent() = 0;
  virtual std::string description() const = 0;  ///< renderer and version, for reports

  const GlFunctions& gl() const noexcept { return gl_; }

 protected:
  GlFunctions gl_;
};

/// The driver's renderer and version.
std::string describeDriver(const GlFunctions& gl);

/// Has software drivers (llvmpipe) draw with `threads` threads, 0: as many as the machine has.
/// The first context of a process decides.
void chooseDriverThreads(int threads);

/// A software context by OSMesa (llvmpipe) that draws with `threads` threads (0: as many as the
/// machine has; the first context of a process decides).  Throws Error (kMachine) when the machine
/// cannot.
std::unique_ptr<GlContext> createOsMesaContext(int threads = 0);

}  // namespace enfilade
