// What the viewer keeps: paths and pictures.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <filesystem>

#include "app/view/viewer.h"
#include "scene/error.h"

namespace enfilade {

void Viewer::toggleRecording() {
  if (!recorder_) {
    trail_.clear();
    recorder_.emplace(RecorderParameters{.vertical_fov = fov_, .name = house_.info.model_name});
    // A path moves doors from how they stand in the house.
    recorder_->addDoors(clock_, stored_);
    recorder_->addDoors(clock_, open_);
    return toast_.say("Recording; R again keeps the path");
  }
  const std::optional<std::string> kept = keepRecording();
  toast_.say(kept ? *kept + "; T plays them" : "Nothing was recorded");
}

std::optional<std::string> Viewer::keepRecording() {
  if (!recorder_) return std::nullopt;
  CameraPath path = recorder_->path();
  recorder_.reset();
  if (path.poses.empty()) return std::nullopt;
  path_ = std::move(path);
  const std::string name = keepName("");
  try {
    writeCameraPath(name + ".json", *path_);
    writeTumPath(name + ".tum", *path_);
    writeGltfPath(name + ".gltf", *path_);
  } catch (const Error& error) {
    return error.what();
  }
  return fmt::format("{} frames kept as {}.json, .tum and .gltf", path_->poses.size(), name);
}

void Viewer::toggleTour() {
  if (playing_) {
    playing_.reset();
    return;
  }
  if (!path_) return toast_.say("No path to play: record one with R, or begin with --tour FILE");
  try {
    playing_ = std::make_unique<PathPlayer>(*path_, house_, options_.tour);
  } catch (const Error& error) {
    return toast_.say(error.what());
  }
  play_time_ = 0;
}

std::string Viewer::keepName(const std::string& extension) const {
  const std::time_t now = std::time(nullptr);
  const std::string base =
      options_.keep_in + fmt::format("/enfilade-{:%Y%m%d-%H%M%S}", fmt::localtime(now));
  std::string name = base;
  for (int i = 2; std::filesystem::exists(name + (extension.empty() ? ".json" : extension)); ++i) {
    name = fmt::format("{}-{}", base, i);
  }
  return name + extension;
}

void Viewer::keepPicture() {
  const glm::ivec2 size = glm::max(window_.size(), 1);
  painter_.resize(size.x, size.y);
  painter_.paint(left_.method, camera(size));
  Image picture;
  painter_.read(picture);
  const std::string name = keepName(".png");
  try {
    writePng(name, picture);
    toast_.say("Kept as " + name);
  } catch (const Error& error) {
    toast_.say(error.what());
  }
}

void Viewer::keepWindow() {
  const std::string name = *keep_window_as_;
  keep_window_as_.reset();
  try {
    writePng(name, overlay_.read());
    toast_.say("Kept as " + name);
  } catch (const Error& error) {
    toast_.say(error.what());
  }
}

}  // namespace enfilade
