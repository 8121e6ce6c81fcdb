#include "app/walk.h"

namespace enfilade {

Camera Walk::stepTo(std::size_t frame, FramePainter& painter) const {
  painter.setFrame(frame);
  const std::vector<std::uint8_t>* open = doors_.at(path_.poses[frame].time);
  if (open != nullptr) painter.setDoors(*open);
  return cameraAt(path_, frame, camera_);
}

}  // namespace enfilade
