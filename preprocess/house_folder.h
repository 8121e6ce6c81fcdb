#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "preprocess/folder_lock.h"

namespace enfilade {

/// A folder in which a house is being made, by one process at a time.  It may be new, empty, a
/// house, or what an interrupted run left; anything else is refused, so that nothing of anyone's is
/// lost.  Folders that were created here and stay empty are removed again.
class HouseFolder {
 public:
  /// Throws Error: kMachine if the folder cannot be written or another process is at work there,
  /// kUsage if it holds something else.
  explicit HouseFolder(const std::string& folder);
  ~HouseFolder();
  HouseFolder(const HouseFolder&) = delete;
  HouseFolder& operator=(const HouseFolder&) = delete;

  const std::string& path() const noexcept { return folder_; }

 private:
  void createMissing();

  std::string folder_;
  std::vector<std::string> created_;  ///< outermost first
  std::optional<FolderLock> lock_;
};

/// The entries of the folder of a house.
const std::set<std::string>& houseEntries();

/// Throws Error (kUsage) if `folder` holds anything but `own` and what was half written of it, or
/// if its images/ holds anything but folders of portal sides.
void refuseOtherThings(const std::string& folder, const std::set<std::string>& own);

/// Whether `entry` is a file of the name of one of `own` that was still being written.
bool isHalfWritten(const std::filesystem::directory_entry& entry, const std::set<std::string>& own);

}  // namespace enfilade
