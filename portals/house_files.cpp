#include "portals/house_files.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <filesystem>

#include "portals/house.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

std::string inFolder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

std::string sideName(PortalId portal, bool from_front) {
  return fmt::format("images/portal-{:04}-{}", portal, from_front ? "front" : "back");
}

void requireFile(const std::string& file) {
  std::error_code ignored;
  if (fs::exists(file, ignored)) return;
  throw Error(ErrorKind::kBadInput, file,
              "is missing, and house.json lists it; preprocess the model again");
}

}  // namespace

std::string houseJsonFile(const std::string& folder) { return inFolder(folder, "house.json"); }
std::string geometryFile(const std::string& folder) { return inFolder(folder, "geometry.glb"); }
std::string cellGridFile(const std::string& folder) { return inFolder(folder, "cells.grid"); }
std::string unfinishedFolder(const std::string& folder) { return inFolder(folder, "unfinished"); }

std::string portalImageFolder(const std::string& folder, PortalId portal, bool from_front) {
  return inFolder(folder, sideName(portal, from_front));
}

std::string portalImageName(PortalId portal, bool from_front, const std::string& file) {
  return sideName(portal, from_front) + "/" + file;
}

std::uint64_t fileChecksum(std::span<const std::uint8_t> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

bool hasFile(const House& house, const std::string& name) { return house.files.contains(name); }

std::vector<std::uint8_t> readHouseFile(const House& house, const std::string& folder,
                                        const std::string& name) {
  const std::string file = inFolder(folder, name);
  const auto listed = house.files.find(name);
  if (listed == house.files.end()) {
    throw Error(ErrorKind::kBadInput, file, "is none of the files that house.json lists");
  }
  requireFile(file);
  std::vector<std::uint8_t> bytes = readFile(file);
  if (fileChecksum(bytes) != listed->second) {
    throw Error(ErrorKind::kBadInput, file,
                "is cut short, damaged, or of another house or portal: its checksum is not the one "
                "in house.json; preprocess the model again");
  }
  return bytes;
}

void requireFiles(const House& house, const std::string& folder) {
  for (const auto& [name, checksum] : house.files) requireFile(inFolder(folder, name));
}

}  // namespace enfilade
