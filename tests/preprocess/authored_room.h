#pragma once

#include <string>

#include "preprocess/authored_names.h"

namespace enfilade {

/// A room of the author's by its bounds alone.
inline AuthoredNames::Room authoredRoom(const std::string& name, const glm::vec3& lo,
                                        const glm::vec3& hi) {
  AuthoredNames::Room result;
  result.name = name;
  result.bounds.extend(lo);
  result.bounds.extend(hi);
  return result;
}

}  // namespace enfilade
