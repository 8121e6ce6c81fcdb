#pragma once

namespace enfilade {

/// The OpenGL functions that we use, filled by a context's own getProcAddress.
struct GlFunctions {};

}  // namespace enfilade
