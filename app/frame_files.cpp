#include "app/frame_files.h"

#include <fmt/format.h>

#include <filesystem>

#include "scene/error.h"

namespace enfilade {

std::string frameFile(Method method, std::size_t frame) {
  return fmt::format("{}/frame-{:05}.png", infoOf(method).name, frame);
}

void removeFramesFrom(std::size_t count, const std::string& folder, Method method) {
  namespace fs = std::filesystem;
  std::error_code error;
  for (std::size_t frame = count; !error; ++frame) {
    const std::string file = folder + "/" + frameFile(method, frame);
    if (!fs::remove(file, error) && !error) return;
    if (error) throw Error(ErrorKind::kMachine, file, "cannot be removed: " + error.message());
  }
}

}  // namespace enfilade
