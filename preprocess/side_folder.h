#pragma once

#include <optional>
#include <string>

#include "portals/cell_graph.h"
#include "portals/house_files.h"

namespace enfilade {

/// The folder of a portal side's images while they are baked: under its name it is there complete
/// or not at all.  A record beside it, sides/portal-PPPP-front or -back, then proves its files, so
/// that what a power cut took is found out without waiting for the disk at every image.
class SideFolder {
 public:
  /// Of `side` in the house in `folder`, from which what is not recorded goes.  Throws Error
  /// (kMachine).
  SideFolder(const std::string& folder, const PortalSide& side);
  ~SideFolder();  ///< removes what was not committed
  SideFolder(const SideFolder&) = delete;
  SideFolder& operator=(const SideFolder&) = delete;

  const std::string& path() const noexcept { return part_; }  ///< where to write

  /// Gives it its name and records it.  Throws Error (kMachine).
  void commit() const;

 private:
  std::string house_folder_;
  PortalSide side_;
  std::string folder_;
  std::string part_;
};

/// Whether `side` is recorded as finished in the house in `folder`.
bool isRecorded(const std::string& folder, const PortalSide& side);

/// The files of `side` in the house in `folder` by the names that a house lists them by; nothing if
/// it is not recorded, or a file is not as it was recorded.
std::optional<HouseFiles> bakedFiles(const std::string& folder, const PortalSide& side);

}  // namespace enfilade
