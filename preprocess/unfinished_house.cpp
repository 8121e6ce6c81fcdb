#include "preprocess/unfinished_house.h"

#include <fmt/format.h>

#include <filesystem>

#include "portals/house_json.h"
#include "preprocess/bake_images.h"
#include "preprocess/house_entries.h"
#include "preprocess/house_swap.h"
#include "preprocess/side_folder.h"
#include "scene/durable.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace fs = std::filesystem;

namespace {

std::string jobFile(const std::string& path) { return path + "/job.json"; }
std::string finishedFile(const std::string& path) { return path + "/finished.json"; }
std::string imagesFolder(const std::string& path) { return path + "/images"; }

std::string textOf(const std::string& file) {
  const std::vector<std::uint8_t> bytes = readFile(file, kMostHouseJsonBytes);
  return {bytes.begin(), bytes.end()};
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

void removeAll(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) {
    throw Error(ErrorKind::kMachine, path.string(), "cannot be removed: " + error.message());
  }
}

/// Throws Error (kBadInput).
House decoded(const std::string& house_json) {
  House house;
  decodeHouseJson(textOf(house_json), house_json, house);
  return house;
}

/// What the house in `folder` lists.  Throws Error (kBadInput).
HouseFiles listedFiles(const std::string& folder) { return decoded(houseJsonFile(folder)).files; }

bool isSound(const std::string& house_json) {
  try {
    decoded(house_json);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

UnfinishedHouse::UnfinishedHouse(std::string house_folder, PreprocessJob job)
    : house_folder_(std::move(house_folder)),
      path_(unfinishedFolder(house_folder_)),
      job_(std::move(job)) {}

UnfinishedHouse::~UnfinishedHouse() {
  std::error_code ignored;
  if (ours_ && !isHouse(path_)) fs::remove_all(path_, ignored);
}

bool UnfinishedHouse::isOfThisJob() const {
  return exists(jobFile(path_)) && textOf(jobFile(path_)) == jobText(job_);
}

std::optional<House> UnfinishedHouse::takeUp(const std::function<void(const std::string&)>& note) {
  if (!exists(path_)) return std::nullopt;
  refuseOtherThings(path_, unfinishedEntries());
  ours_ = true;
  std::string why;
  try {
    if (isHouse(path_) && isOfThisJob()) return readHouse(path_);
    if (isHouse(path_) && exists(jobFile(path_)))
      why = differenceOfJobs(textOf(jobFile(path_)), job_);
  } catch (const Error& error) {
    why = error.what();
  }
  if (note && !why.empty()) note(fmt::format("{}: cannot be gone on with: {}", path_, why));
  unswapHouse(house_folder_, path_);  // an older house that was on its way out
  removeAll(path_);
  return std::nullopt;
}

std::optional<House> UnfinishedHouse::takeUpFinished() {
  if (!isOfThisJob()) return std::nullopt;
  if (isInPlace()) {
    House house = readHouse(house_folder_);
    tidyUp();
    return house;
  }
  if (!exists(finishedFile(path_))) return std::nullopt;
  if (!isSound(finishedFile(path_))) {  // a power cut took what was in it
    removeAll(finishedFile(path_));
    return std::nullopt;
  }
  moveIntoPlace();
  return readHouse(house_folder_);
}

bool UnfinishedHouse::isInPlace() const {
  if (exists(geometryFile(path_)) || !isHouse(path_) || !isHouse(house_folder_)) return false;
  try {
    return listedFiles(path_).at("geometry.glb") == listedFiles(house_folder_).at("geometry.glb");
  } catch (const std::exception&) {
    return false;
  }
}

House UnfinishedHouse::write(const House& house) {
  removeAll(path_);
  createFolders(path_);
  ours_ = true;
  writeFileAtomically(jobFile(path_), jobText(job_));
  writeHouse(path_, house);
  return readHouse(path_);
}

void UnfinishedHouse::finish(const House& house) {
  createFolders(imagesFolder(path_));
  for (const auto& side : fs::directory_iterator(imagesFolder(path_))) {
    if (side.is_directory()) syncFolder(side.path().string());
  }
  syncFolder(imagesFolder(path_));
  syncFolder(path_);  // all that it lists, before it says that all is there
  writeFileAtomically(finishedFile(path_), encodeHouseJson(house, house.files));
  syncFolder(path_);
  moveIntoPlace();
}

void UnfinishedHouse::moveIntoPlace() {
  swapHouse(house_folder_, path_);
  for (const auto& entry : fs::directory_iterator(house_folder_)) {
    if (isHalfWritten(entry, houseEntries())) removeAll(entry.path());
  }
  syncFolder(house_folder_);
  tidyUp();
}

void UnfinishedHouse::tidyUp() {
  removeAll(replacedFolder(path_));
  removeAll(jobFile(path_));  // first: without it nobody goes on
  removeAll(path_);
}

std::string describeUnfinished(const std::string& folder) {
  const std::string path = unfinishedFolder(folder);
  if (!isHouse(path)) return {};
  House house;
  try {
    house = decoded(houseJsonFile(path));
  } catch (const Error&) {
    return {};
  }
  const std::vector<PortalSide> sides = sidesWithImages(house.graph);
  std::size_t finished = 0;
  for (const PortalSide& side : sides) finished += isRecorded(path, side);
  return fmt::format("{} of {} portal sides are finished and kept in {}", finished, sides.size(),
                     path);
}

}  // namespace enfilade
