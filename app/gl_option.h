#pragma once

#include <CLI/CLI.hpp>

#include "render/gl_context.h"

namespace enfilade {

/// Adds --gl, which sets `backend`.  Throws Error (kUsage) for a name that is none.
CLI::Option* addGlOption(CLI::App& command, GlBackend& backend);

}  // namespace enfilade
