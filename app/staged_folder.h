#pragma once

#include <set>
#include <string>

namespace enfilade {

/// By what a folder of some kind is known, and what of it is the program's own.
struct FolderKind {
  std::set<std::string> proof;  ///< files that each such folder has
  std::set<std::string> own;    ///< what the program writes there, those among it
};

/// A folder that is there complete or not at all: built as FOLDER.tmp-PID beside it, then renamed.
/// Where the system can, an older one and it change places at once.  What else stands in the older
/// one is a person's, and is moved into the new one.
class StagedFolder {
 public:
  /// Creates the temporary folder.  An older folder of the same kind, or an empty one, will be
  /// replaced; anything else is refused, and so is what cannot be replaced: the folder that one is
  /// in, and where something is mounted.  A symbolic link to a folder stays one.  Throws Error:
  /// kUsage when refused, kMachine with the system's reason.
  StagedFolder(const std::string& folder, FolderKind kind);
  ~StagedFolder();  ///< removes what was not committed
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::string& path() const noexcept { return temporary_; }  ///< where to write

  /// `message` with the names that the files in the folder will have, for a person.
  std::string asCommitted(std::string message) const;

  /// Puts the folder in its place.  Throws Error (kMachine): if something has appeared there that
  /// was not there at first, it and the new folder both stay.
  void commit();

 private:
  void commitAsNew();
  void replaceOld();

  std::string folder_;
  FolderKind kind_;
  std::string temporary_;
  bool replaces_ = false;
  bool committed_ = false;
};

}  // namespace enfilade
