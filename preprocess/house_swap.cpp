#include "preprocess/house_swap.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace fs = std::filesystem;

namespace {

/// A part of a house, and what it is called before the house is complete.
struct Part {
  const char* name;
  const char* new_name;
};

// In the order in which they come; they go in the other, so that a house is one only when whole.
constexpr std::array<Part, 4> kParts = {{{"cells.grid", "cells.grid"},
                                         {"geometry.glb", "geometry.glb"},
                                         {"images", "images"},
                                         {"house.json", "finished.json"}}};

/// A link is one, whatever it leads to.
bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

void require(const std::error_code& error, const fs::path& path) {
  if (error) {
    throw Error(ErrorKind::kMachine, path.string(), "cannot be replaced: " + error.message());
  }
}

void moveAway(const Part& part, const fs::path& folder, const fs::path& from) {
  if (!isThere(from / part.new_name) || !isThere(folder / part.name)) return;
  std::error_code error;
  fs::rename(folder / part.name, fs::path(replacedFolder(from.string())) / part.name, error);
  require(error, folder / part.name);
}

void moveIn(const Part& part, const fs::path& folder, const fs::path& from) {
  const fs::path source = from / part.new_name, place = folder / part.name;
  if (!isThere(source)) return;
  std::error_code error;
  if (fs::is_directory(source) && fs::is_empty(source)) {
    fs::remove(source, error);  // a house without images has no folder for them
  } else {
    fs::rename(source, place, error);
  }
  require(error, place);
}

}  // namespace

std::string replacedFolder(const std::string& from) { return from + "/replaced"; }

void swapHouse(const std::string& folder, const std::string& from) {
  createFolders(replacedFolder(from));
  try {
    std::for_each(kParts.rbegin(), kParts.rend(),
                  [&](const Part& part) { moveAway(part, folder, from); });
  } catch (const Error&) {
    unswapHouse(folder, from);
    throw;
  }
  for (const Part& part : kParts) moveIn(part, folder, from);
}

void unswapHouse(const std::string& folder, const std::string& from) {
  const auto is_new_there = [&](const Part& part) { return !isThere(from + "/" + part.new_name); };
  if (std::any_of(kParts.begin(), kParts.end(), is_new_there)) return;
  for (const Part& part : kParts) {
    const fs::path old = fs::path(replacedFolder(from)) / part.name;
    const fs::path place = fs::path(folder) / part.name;
    std::error_code ignored;
    if (isThere(old) && !isThere(place)) fs::rename(old, place, ignored);
  }
}

}  // namespace enfilade
