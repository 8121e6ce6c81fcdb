#include "app/frame_files.h"

#include <fmt/format.h>

namespace enfilade {

std::string frameFile(Method method, std::size_t frame) {
  return fmt::format("{}/frame-{:05}.png", infoOf(method).name, frame);
}

}  // namespace enfilade
