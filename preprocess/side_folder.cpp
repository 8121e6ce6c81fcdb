#include "preprocess/side_folder.h"

#include <filesystem>
#include <sstream>

#include "portals/house_json.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

namespace fs = std::filesystem;

/// The last line of a record: without it the record is not whole.
constexpr const char* kEnd = "end";

std::string folderOf(const std::string& folder, const PortalSide& side) {
  return portalImageFolder(folder, side.portal, side.from_front);
}

std::string nameOf(const PortalSide& side) {
  return fs::path(folderOf({}, side)).filename().string();
}

std::string recordOf(const std::string& folder, const PortalSide& side) {
  return folder + "/sides/" + nameOf(side);
}

void remove(const std::string& path) noexcept {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

std::string checksumOfFile(const std::string& file) {
  return checksumText(fileChecksum(readFile(file)));
}

}  // namespace

SideFolder::SideFolder(const std::string& folder, const PortalSide& side)
    : house_folder_(folder),
      side_(side),
      folder_(folderOf(folder, side)),
      part_(folder_ + ".part") {
  // What a killed run left, or what is no longer as it was recorded.
  remove(recordOf(folder, side));
  remove(folder_);
  remove(part_);
  createFolders(part_);
}

SideFolder::~SideFolder() { remove(part_); }

void SideFolder::commit() const {
  std::string record = nameOf(side_) + "\n";
  for (const auto& entry : fs::directory_iterator(part_)) {
    record += checksumOfFile(entry.path().string()) + " " + entry.path().filename().string() + "\n";
  }
  std::error_code error;
  fs::rename(part_, folder_, error);
  if (error) throw Error(ErrorKind::kMachine, folder_, "cannot be written: " + error.message());
  createFolders(house_folder_ + "/sides");
  writeFileAtomically(recordOf(house_folder_, side_), record + kEnd + "\n");
}

bool isRecorded(const std::string& folder, const PortalSide& side) {
  std::error_code ignored;
  return fs::is_regular_file(recordOf(folder, side), ignored);
}

std::optional<HouseFiles> bakedFiles(const std::string& folder, const PortalSide& side) {
  if (!isRecorded(folder, side)) return std::nullopt;
  HouseFiles files;
  try {
    const std::vector<std::uint8_t> record = readFile(recordOf(folder, side));
    std::istringstream lines(std::string(record.begin(), record.end()));
    std::string of, checksum, file;
    lines >> of;
    while (lines >> checksum && checksum != kEnd && lines >> file) {
      const std::vector<std::uint8_t> bytes = readFile(folderOf(folder, side) + "/" + file);
      if (checksumText(fileChecksum(bytes)) != checksum) return std::nullopt;
      files[portalImageName(side.portal, side.from_front, file)] = fileChecksum(bytes);
    }
    if (of == nameOf(side) && checksum == kEnd && !files.empty()) return files;
  } catch (const Error&) {
    // A file that is gone is one that is not as it was recorded.
  }
  return std::nullopt;
}

}  // namespace enfilade
