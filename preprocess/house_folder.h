#pragma once

#include <optional>
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

}  // namespace enfilade
