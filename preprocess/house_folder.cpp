#include "preprocess/house_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "scene/error.h"

namespace enfilade {

namespace fs = std::filesystem;

bool isHalfWritten(const std::string& name) { return name.find(".tmp-") != std::string::npos; }

void refuseOtherThings(const std::string& folder, const std::set<std::string>& own) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (own.contains(name) || isHalfWritten(name)) continue;
    throw Error(ErrorKind::kUsage, folder,
                "holds other things (" + name + "): choose a new folder for the house");
  }
}

HouseFolder::HouseFolder(const std::string& folder) : folder_(folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw Error(ErrorKind::kUsage, folder, "is a file; a house is a folder");
  }
  do {  // again, if a run that ends has just removed it
    createMissing();
    lock_.emplace(folder);
  } while (!lock_->holds(folder));
  refuseOtherThings(folder, {"house.json", "geometry.glb", "cells.grid", "images", "unfinished"});
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw Error(ErrorKind::kMachine, folder,
                std::string("cannot be written to: ") + std::strerror(errno));
  }
}

HouseFolder::~HouseFolder() {
  std::error_code ignored;
  while (!created_.empty()) {
    fs::remove(created_.back(), ignored);  // unless something is in it
    created_.pop_back();
  }
}

void HouseFolder::createMissing() {
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path at = fs::absolute(folder_, error).lexically_normal(); !fs::exists(at, error);
       at = at.parent_path()) {
    if (at.has_filename()) missing.push_back(at);
  }
  std::reverse(missing.begin(), missing.end());
  for (const fs::path& at : missing) {
    if (fs::create_directory(at, error)) created_.push_back(at.string());
    if (error) throw Error(ErrorKind::kMachine, folder_, "cannot be created: " + error.message());
  }
}

}  // namespace enfilade
