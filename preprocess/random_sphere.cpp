#include "preprocess/random_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enfilade {

float randomUnit(std::mt19937& random) { return static_cast<float>(random()) * 0x1p-32f; }

glm::vec3 randomDirection(std::mt19937& random) {
  const float y = 2 * randomUnit(random) - 1;
  const float angle = 2 * std::numbers::pi_v<float> * randomUnit(random);
  const float r = std::sqrt(std::max(0.0f, 1 - y * y));
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

glm::vec3 randomInCube(std::mt19937& random) {
  const float x = randomUnit(random);
  const float y = randomUnit(random);
  const float z = randomUnit(random);
  return 2.0f * glm::vec3(x, y, z) - 1.0f;
}

}  // namespace enfilade
