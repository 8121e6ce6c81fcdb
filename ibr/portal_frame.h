#pragma once

#include <glm/glm.hpp>

#include "portals/cell_graph.h"

namespace enfilade {

/// A portal as an image plane: its bounding rectangle, upright, as a viewer on one side sees it.
struct PortalFrame {
  glm::dvec3 center{0};        ///< of the rectangle [m]
  glm::dvec3 right{1, 0, 0};   ///< unit, horizontal, to the viewer's right
  glm::dvec3 up{0, 1, 0};      ///< unit, in the portal's plane
  glm::dvec3 toward{0, 0, 1};  ///< unit normal, toward the viewer
  double half_width = 0;       ///< [m]
  double half_height = 0;      ///< [m]
};

/// The frame of a portal that is not horizontal.
PortalFrame portalFrame(const Portal& portal, bool from_front);

/// Level, toward the viewer; unit.
glm::dvec3 levelAhead(const PortalFrame& frame);

/// Whether `viewpoint` stands before the portal's plane, by 5 cm or more: what can be captured
/// from.
bool standsBefore(const PortalFrame& frame, const glm::dvec3& viewpoint);

}  // namespace enfilade
