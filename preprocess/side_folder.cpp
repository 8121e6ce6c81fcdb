#include "preprocess/side_folder.h"

#include <filesystem>

#include "portals/house_files.h"
#include "scene/durable.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

std::string folderOf(const std::string& folder, const PortalSide& side) {
  return portalImageFolder(folder, side.portal, side.from_front);
}

void remove(const std::string& folder) noexcept {
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

}  // namespace

SideFolder::SideFolder(const std::string& folder, const PortalSide& side)
    : folder_(folderOf(folder, side)), part_(folder_ + ".part") {
  remove(part_);  // what a killed run left
  createFolders(part_);
}

SideFolder::~SideFolder() { remove(part_); }

void SideFolder::commit() const {
  syncFolder(part_);
  std::error_code error;
  std::filesystem::rename(part_, folder_, error);
  if (error) throw Error(ErrorKind::kMachine, folder_, "cannot be written: " + error.message());
}

bool isBaked(const std::string& folder, const PortalSide& side) {
  std::error_code ignored;
  return std::filesystem::is_directory(folderOf(folder, side), ignored);
}

}  // namespace enfilade
