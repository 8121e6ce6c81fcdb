#pragma once

#include <string>

namespace enfilade {

/// A file that is there complete or not at all, written by another program: FILE.tmp-PID beside it,
/// then renamed.
class StagedFile {
 public:
  /// Creates the temporary file, so that a place that cannot be written to is known at once.
  /// Throws Error (kMachine) with the system's reason.
  explicit StagedFile(const std::string& file);
  ~StagedFile();  ///< removes what was not committed
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;

  const std::string& path() const noexcept { return temporary_; }  ///< where to write

  /// Puts the file in its place.  Throws Error (kMachine).
  void commit();

 private:
  std::string file_;
  std::string temporary_;
  bool committed_ = false;
};

}  // namespace enfilade
