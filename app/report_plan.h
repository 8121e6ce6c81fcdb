#pragma once

#include <string>
#include <vector>

#include "portals/house.h"
#include "scene/camera_path.h"

namespace enfilade {

/// A house's plan with a walk on it, for a page to draw.  Lengths are the drawing's pixels.
struct ReportPlan {
  struct Storey {
    std::string name;
    float floor_y = 0;    ///< [m]
    std::string drawing;  ///< SVG elements: cells, walls, portals, names
  };
  struct Step {
    glm::vec2 place{0};  ///< right and down
    float heading = 0;   ///< [degrees] clockwise from the right, as the drawing shows it
    std::size_t storey = 0;
  };
  glm::vec2 size{0};  ///< of every storey
  float scale = 0;    ///< [pixels/m]
  std::vector<Storey> storeys;
  std::vector<Step> steps;  ///< one a frame
};

/// The storeys and the path, cropped to the rooms and what the path adds to them.
ReportPlan planOf(const House& house, const CameraPath& path);

}  // namespace enfilade
