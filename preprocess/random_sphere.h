#pragma once

#include <glm/glm.hpp>
#include <random>

namespace enfilade {

/// 0…1, the same on every machine.
float randomUnit(std::mt19937& random);
/// Unit vectors, all equally likely.
glm::vec3 randomDirection(std::mt19937& random);
/// −1…1 each.
glm::vec3 randomInCube(std::mt19937& random);

}  // namespace enfilade
