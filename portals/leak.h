#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace enfilade {

/// A way out of a room that no portal closes, so that the room is one with what it leads to.
struct Leak {
  std::string room;             ///< that is no cell for it
  std::string into;             ///< the cell that it is part of
  std::vector<glm::vec3> path;  ///< [m] from the room's middle to a little beyond, straight parts
  glm::vec3 place{0};           ///< [m] where it leaves the room
};

}  // namespace enfilade
