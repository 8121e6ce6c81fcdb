#pragma once

#include "render/gl_context.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace enfilade {

/// Adds --gl, which sets `backend`.  Throws Error (kUsage) for a name that is none.
CLI::Option* addGlOption(CLI::App& command, GlBackend& backend);

}  // namespace enfilade
