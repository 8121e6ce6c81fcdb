#include "preprocess/house_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "preprocess/house_entries.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace fs = std::filesystem;

namespace {

constexpr int kMostTurns = 100;  // of runs that remove a folder just when it is to be locked

}  // namespace

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
  refuseOtherThings(folder, holdsHouse(folder) ? houseEntries() : std::set<std::string>());
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
