#pragma once

#include <string>
#include <vector>

#include "scene/geometry.h"

namespace enfilade {

/// How far apart neighbouring 32-bit coordinates lie at the corner of `bounds` that is farthest
/// from the origin [m]: nothing in a building there is placed more finely.
float coordinateStep(const Box& bounds);

/// What looks wrong with the size and the place of a building that fills `bounds`, a line each;
/// nothing is said of empty ones.
std::vector<std::string> extentDoubts(const Box& bounds);

/// `length` [m] in the unit that suits it: "8 mm", "2.46 m", "100 km".
std::string lengthText(float length);

}  // namespace enfilade
