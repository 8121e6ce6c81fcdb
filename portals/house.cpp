#include "portals/house.h"

#include <fmt/format.h>

#include <cassert>
#include <filesystem>

#include "portals/grid_file.h"
#include "portals/house_json.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"

namespace enfilade {

namespace {

constexpr const char* kGeometry = "geometry.glb";
constexpr const char* kGrid = "cells.grid";

void requireHouse(const std::string& folder) {
  std::error_code ignored;
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::kBadInput, folder, reason);
  };
  if (!std::filesystem::exists(folder, ignored)) {
    fail(ignored ? "cannot be read: " + ignored.message() : "no such file or folder");
  }
  if (!std::filesystem::is_directory(folder, ignored)) fail("is a file, not a house folder");
  if (isHouse(folder)) return;
  if (std::filesystem::is_directory(unfinishedFolder(folder), ignored)) {
    fail(
        "is a house that is not yet finished: let its 'enfilade preprocess' come to its end, or "
        "give the same again if it was stopped");
  }
  std::error_code error;
  (void)std::filesystem::status(houseJsonFile(folder), error);
  if (error == std::errc::permission_denied) fail("cannot be read: " + error.message());
  if (!error) fail("is not a house: its house.json is no file");
  fail("is not a house: it has no house.json");
}

void requireLabelsOfCells(const House& house, const std::string& file) {
  for (const CellGrid::Run& run : house.grid.runs()) {
    const bool special = run.label == CellGrid::kSolidVoxel || run.label == CellGrid::kCutVoxel;
    if (!special && run.label >= house.graph.cells.size()) {
      throw Error(ErrorKind::kBadInput, file, "has voxels of a cell that the house has not");
    }
  }
}

}  // namespace

std::vector<std::uint8_t> doorFlags(std::span<const ObjectRole> roles) {
  std::vector<std::uint8_t> flags;
  for (const ObjectRole role : roles) flags.push_back(role == ObjectRole::kDoor);
  return flags;
}

bool isHouse(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(houseJsonFile(path), ignored);
}

void writeHouse(const std::string& folder, const House& house) {
  assert(house.object_roles.size() == house.building.objects.size());
  assert(house.object_cells.size() == house.building.objects.size());
  createFolders(folder);
  // From here until its new house.json stands the folder is no house.
  std::error_code error;
  std::filesystem::remove(houseJsonFile(folder), error);
  if (error) {
    throw Error(ErrorKind::kMachine, houseJsonFile(folder),
                "cannot be replaced: " + error.message());
  }
  HouseFiles files = house.files;
  const std::vector<std::uint8_t> grid = encodeGrid(house.grid);
  writeFileAtomically(cellGridFile(folder), grid);
  files[kGrid] = fileChecksum(grid);
  const std::vector<std::uint8_t> geometry = encodeGlb(house.building);
  writeFileAtomically(geometryFile(folder), geometry);
  files[kGeometry] = fileChecksum(geometry);
  writeFileAtomically(houseJsonFile(folder), encodeHouseJson(house, files));
}

House readHouse(const std::string& folder) {
  requireHouse(folder);
  House house;
  const std::vector<std::uint8_t> text = readFile(houseJsonFile(folder), kMostHouseJsonBytes);
  decodeHouseJson(std::string(text.begin(), text.end()), houseJsonFile(folder), house);
  const std::string grid_file = cellGridFile(folder);
  house.grid = decodeGrid(readHouseFile(house, folder, kGrid), grid_file);
  requireLabelsOfCells(house, grid_file);

  const std::string geometry_file = geometryFile(folder);
  house.building = decodeGltf(readHouseFile(house, folder, kGeometry), geometry_file);
  if (house.building.objects.size() != house.object_roles.size()) {
    throw Error(ErrorKind::kBadInput, geometry_file,
                fmt::format("has {} objects, but house.json speaks of {}",
                            house.building.objects.size(), house.object_roles.size()));
  }
  return house;
}

}  // namespace enfilade
