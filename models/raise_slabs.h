#pragma once

#include "models/raise_walls.h"

namespace enfilade {

enum class SlabSide { kTop, kUnderside };

/// The flat surface inside an outline, joined to the walls' faces at their breaks.
struct SlabLook {
  SlabSide side = SlabSide::kTop;
  double level = 0;         ///< [m]
  double size = 1;          ///< [m] that the picture spans
  double edge_shade = 1;    ///< 0…1 along the walls, 1 from `edge_width` on
  double edge_width = 0.6;  ///< [m]; less where the outline is narrow, or a hole near
  std::vector<std::vector<glm::dvec2>> holes{};  ///< of positive area, inside, apart
};

void raiseSlab(const Outline& outline, const OutlineBreaks& breaks, const SlabLook& look,
               MeshBuilder& mesh);

/// The sides of a well through a floor, from `low` to `high`, seen from inside it.
void raiseWell(const std::vector<glm::dvec2>& corners, double low, double high, double size,
               MeshBuilder& mesh);

/// The flat roof behind a parapet: the coping on top of the outer walls, the parapet's inner
/// faces to `coping`; the roof itself to `roof`.  `outline` is the exterior's.
void raiseRoof(const Outline& outline, const OutlineBreaks& breaks, double parapet_top,
               double roof_level, double parapet_width, double size, MeshBuilder& coping,
               MeshBuilder& roof);

/// A level rectangle, `margin` wider than the outline on every side.
void raiseGround(const Outline& outline, double level, double margin, double size,
                 MeshBuilder& mesh);

}  // namespace enfilade
