#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace enfilade {

/// Plan geometry, points (x, z) in metres.  A polygon's inside lies to the left of its edges, where
/// left of (1, 0) is (0, 1); its area is then positive.

inline double planCross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }
inline glm::dvec2 leftOf(const glm::dvec2& direction) { return {-direction.y, direction.x}; }

double signedArea(std::span<const glm::dvec2> polygon);
bool containsPoint(std::span<const glm::dvec2> polygon, const glm::dvec2& p);
bool isConvex(std::span<const glm::dvec2> polygon);

/// Where two lines through `corner`, along unit `d1` and `d2`, meet after moving left by `h1` and
/// `h2`.  The directions must not be parallel.
glm::dvec2 movedCorner(const glm::dvec2& corner, const glm::dvec2& d1, double h1,
                       const glm::dvec2& d2, double h2);

/// The polygon with every edge moved inward by `distance`; same number of corners.  Right only
/// while no edge vanishes: see isInsetValid.
std::vector<glm::dvec2> inset(std::span<const glm::dvec2> polygon, double distance);

/// Whether every edge of `inner` still runs the way of the edge of `polygon` that it comes from.
bool isInsetValid(std::span<const glm::dvec2> polygon, std::span<const glm::dvec2> inner);

}  // namespace enfilade
