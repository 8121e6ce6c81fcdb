#pragma once

#include <gtest/gtest.h>

#include "preprocess/tour.h"

namespace enfilade::testing {

/// The distance from `p` to the nearest triangle of anything but doors, by trying them all.
double bruteDistance(const House& house, const glm::vec3& p);

/// Whether the straight line from `a` to `b` crosses such a triangle, by trying them all.
bool bruteCrosses(const House& house, const glm::vec3& a, const glm::vec3& b);

/// Exactly `frames` poses, none within 0.15 m of anything, no line between two through anything,
/// cells following each other through portals, +Y up, no great pitch.
void expectWalked(const House& house, const Tour& tour, int frames);

/// The greatest step [m] and turn [rad] between two poses.
float longestStep(const Tour& tour);
float sharpestTurn(const Tour& tour);
/// [m]
float lengthOf(const Tour& tour);

/// Whether some note holds all of `words`.
bool noted(const Tour& tour, const std::vector<std::string>& words);

}  // namespace enfilade::testing
