#include "preprocess/house_folder.h"

#include <unistd.h>

#include <filesystem>
#include <set>
#include <system_error>

#include "portals/house.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace fs = std::filesystem;

namespace {

std::set<std::string> ownNames(const std::string& folder) {
  return {fs::path(houseJsonFile(folder)).filename().string(),
          fs::path(geometryFile(folder)).filename().string(),
          fs::path(cellGridFile(folder)).filename().string(), "images"};
}

}  // namespace

HouseFolder::HouseFolder(const std::string& folder) : folder_(folder) {
  std::error_code error;
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error)) {
      throw Error(ErrorKind::kUsage, folder, "is a file; a house is a folder");
    }
    const std::set<std::string> own = ownNames(folder);
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const std::string name = entry.path().filename().string();
      if (own.contains(name) || name.find(".tmp-") != std::string::npos) continue;
      throw Error(ErrorKind::kUsage, folder,
                  "holds other things (" + name + "): choose a new folder for the house");
    }
  } else {
    createFolders(folder);
    created_ = true;
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw Error(ErrorKind::kMachine, folder, "cannot be written to");
  }
}

HouseFolder::~HouseFolder() {
  if (finished_ || !created_) return;
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void HouseFolder::clear() {
  std::error_code error;
  fs::remove(houseJsonFile(folder_), error);  // first: from here on it is no house
  fs::remove_all(fs::path(folder_) / "images", error);
  if (error) throw Error(ErrorKind::kMachine, folder_, error.message());
}

}  // namespace enfilade
