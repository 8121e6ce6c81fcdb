#pragma once

#include <cstddef>

#include "portals/cell_graph.h"

namespace enfilade {

/// The colour that a kind of portal has in every picture of a house, 0xRRGGBB, sRGB.
constexpr unsigned portalColor(PortalKind kind) noexcept {
  constexpr unsigned kColors[] = {0x0a7d4f, 0xd1570b, 0x1467c8};  // by PortalKind
  return kColors[static_cast<std::size_t>(kind)];
}

}  // namespace enfilade
