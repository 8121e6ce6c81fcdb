#pragma once

#include <vector>

#include "ibr/ldi_builder.h"

namespace enfilade::testing {

/// What LdiBuilder builds of these captures, by its rules as they are written, pixel by pixel and
/// with no thought of speed.
Ldi plainLdi(const PlanarCamera& central, const LdiRules& rules,
             const std::vector<CaptureSamples>& captures);

}  // namespace enfilade::testing
