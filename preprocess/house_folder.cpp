#include "preprocess/house_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>

#include "portals/house_files.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace fs = std::filesystem;

namespace {

constexpr int kMostTurns = 100;  // of runs that remove a folder just when it is to be locked

[[noreturn]] void refuse(const std::string& folder, const std::string& name) {
  throw Error(ErrorKind::kUsage, folder,
              "holds other things (" + name + "): choose a new folder for the house");
}

/// "portal-0012-front", and what it is called while it is baked.
bool isSideName(std::string_view name) {
  constexpr std::string_view kStart = "portal-", kPart = ".part";
  if (!name.starts_with(kStart)) return false;
  name.remove_prefix(kStart.size());
  const std::size_t digits = name.find_first_not_of("0123456789");
  if (digits == 0 || digits == std::string_view::npos) return false;
  name.remove_prefix(digits);
  if (name.ends_with(kPart)) name.remove_suffix(kPart.size());
  return name == "-front" || name == "-back";
}

}  // namespace

const std::set<std::string>& houseEntries() {
  static const std::set<std::string> entries = {"house.json", "geometry.glb", "cells.grid",
                                                "images", "unfinished"};
  return entries;
}

bool isHalfWritten(const fs::directory_entry& entry, const std::set<std::string>& own) {
  const std::string name = entry.path().filename().string();
  const std::size_t end = name.find(kTemporaryMark);
  return end != std::string::npos && own.contains(name.substr(0, end)) &&
         name.find_first_not_of("0123456789-", end + kTemporaryMark.size()) == std::string::npos &&
         entry.symlink_status().type() == fs::file_type::regular;
}

void refuseOtherThings(const std::string& folder, const std::set<std::string>& own) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!own.contains(name) && !isHalfWritten(entry, own)) refuse(folder, name);
  }
  const std::string images = folder + "/images";
  if (fs::exists(images, error) && !fs::is_directory(images, error)) refuse(folder, "images");
  for (const auto& entry : fs::directory_iterator(images, error)) {
    const std::string name = entry.path().filename().string();
    if (!isSideName(name)) refuse(folder, "images/" + name);
  }
}

HouseFolder::HouseFolder(const std::string& folder) : folder_(folder) {
  if (folder.empty()) throw Error(ErrorKind::kUsage, "", "the name of the house's folder is empty");
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw Error(ErrorKind::kUsage, folder, "is a file; a house is a folder");
  }
  if (fs::is_symlink(fs::symlink_status(folder, error)) && !fs::exists(folder, error)) {
    throw Error(ErrorKind::kUsage, folder, "is a symbolic link to nothing");
  }
  for (int turn = 0; !lock_ || !lock_->holds(folder); ++turn) {
    // Again, if a run that ends has just removed it.
    if (turn == kMostTurns) throw Error(ErrorKind::kMachine, folder, "cannot be created");
    createMissing();
    lock_.emplace(folder);
  }
  // What bears a house's names is one's own only where there is a house, or one in the making.
  const bool has_house =
      fs::exists(folder + "/house.json", error) || fs::exists(unfinishedFolder(folder), error);
  refuseOtherThings(folder, has_house ? houseEntries() : std::set<std::string>());
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
  // Not made normal: link/../house is not beside the link but beside what that points to.
  for (fs::path at = fs::absolute(folder_, error); at.has_relative_path() && !fs::exists(at, error);
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
