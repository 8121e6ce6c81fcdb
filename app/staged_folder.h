#pragma once

#include <string>

namespace enfilade {

/// A folder that is there complete or not at all: built as FOLDER.tmp-PID beside it, then renamed.
class StagedFolder {
 public:
  /// Creates the temporary folder.  `proof` is the file by which an older folder of the same kind
  /// is known: one that has it, or is empty, will be replaced; anything else is refused. Throws
  /// Error: kUsage when refused, kMachine with the system's reason.
  StagedFolder(const std::string& folder, const std::string& proof);
  ~StagedFolder();  ///< removes what was not committed
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::string& path() const noexcept { return temporary_; }  ///< where to write

  /// Puts the folder in its place.  Throws Error (kMachine).
  void commit();

 private:
  std::string folder_;
  std::string temporary_;
  bool committed_ = false;
};

}  // namespace enfilade
