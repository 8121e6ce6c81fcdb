#pragma once

#include <string>

namespace enfilade {

/// One process at a time has a folder.  The system lets go of it when the process ends, however it
/// ends, and nothing is left in the folder.
class FolderLock {
 public:
  /// Throws Error (kMachine) if another process has it.  Where the file system knows no locks, all
  /// may have it.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether `folder` still names what is locked: it may have been removed just before.
  bool holds(const std::string& folder) const;

 private:
  int fd_;
};

}  // namespace enfilade
