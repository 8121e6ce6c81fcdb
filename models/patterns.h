#pragma once

#include <string>
#include <vector>

#include "models/floor_plan.h"
#include "scene/image.h"

namespace enfilade {

/// Paints one point of a finish: `uv` in 0…1, row 0 of the picture at v = 0, sRGB 0…1.
using PatternPainter = glm::dvec3 (*)(const PlanFinish& finish, const glm::dvec2& uv);

/// A way to paint a finish.
struct PatternKind {
  const char* name;
  int width, height;  ///< [pixels] of the picture; 0: none, the first colour is all
  PatternPainter paint;
};

/// Floors and materials (patterns.cpp), walls from skirting to cornice (wall_patterns.cpp),
/// pictures to hang (pictures.cpp).  All but the pictures repeat without a seam.
std::vector<PatternKind> materialPatterns();
std::vector<PatternKind> wallPatterns();
std::vector<PatternKind> picturePatterns();

bool isPattern(const std::string& name);
std::vector<std::string> patternNames();

/// The picture of a finish.  The same pixels run after run.
Image paintPattern(const PlanFinish& finish);

/// The finish's colour number `i`, or its last.
const glm::dvec3& colorOf(const PlanFinish& finish, std::size_t i);

}  // namespace enfilade
