#pragma once

#include <string>

namespace enfilade {

/// A folder in which a house is being written.  It may be new, empty, a house, or what an
/// interrupted run left; anything else is refused, so that nothing of anyone's is lost.  The old
/// house there ends when writing begins.  If finish() is never reached, a folder that was created
/// here is removed again.
class HouseFolder {
 public:
  /// Throws Error (kMachine) if the folder cannot be written, (kUsage) if it holds something else.
  explicit HouseFolder(const std::string& folder);
  ~HouseFolder();
  HouseFolder(const HouseFolder&) = delete;
  HouseFolder& operator=(const HouseFolder&) = delete;

  /// Removes the old house's files.
  void clear();
  void finish() noexcept { finished_ = true; }

 private:
  std::string folder_;
  bool created_ = false;
  bool finished_ = false;
};

}  // namespace enfilade
