#pragma once

#include <limits>
#include <string>

#include "app/plan_slice.h"
#include "portals/house.h"

namespace enfilade {

/// The part of the ground that every storey of a plan shows: x and z [m].
struct PlanCrop {
  glm::vec2 low{std::numeric_limits<float>::infinity()};
  glm::vec2 high{-std::numeric_limits<float>::infinity()};
  float scale = 40.0f;  ///< [pixels/m]

  glm::vec2 pixels(float x, float z) const { return scale * (glm::vec2(x, z) - low); }
  glm::vec2 size() const { return scale * (high - low); }
};

/// `text` fit to stand in XML.
std::string escapedXml(const std::string& text);

/// The squares of `label` as a path of SVG; empty if there are none.
std::string outlinePath(const PlanSlice& slice, CellGrid::Label label, const PlanCrop& crop);

/// The cell's name and area where there is room for them; empty if it is hardly to be seen.
std::string cellLabel(const PlanSlice& slice, const CellGraph& graph, CellId id,
                      const PlanCrop& crop);

/// A portal as a line, dashed all around if it lies level, with what it joins as its title.
std::string portalMark(const CellGraph& graph, PortalId id, const PlanCrop& crop);

/// A leak's path from the room outwards, a ring where it leaves the room, the room's name at its
/// beginning.
std::string leakMark(const Leak& leak, const PlanCrop& crop);

/// A scale bar and what the colours of the portals mean, and that of leaks if there are any.
std::string planFoot(const PlanCrop& crop, bool leaks);

}  // namespace enfilade
