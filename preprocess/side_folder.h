#pragma once

#include <string>

#include "portals/cell_graph.h"

namespace enfilade {

/// The folder of a portal side's images while they are baked: under its name it is there complete,
/// and on the disk, or not at all.
class SideFolder {
 public:
  /// Of `side` in the house in `folder`.  Throws Error (kMachine).
  SideFolder(const std::string& folder, const PortalSide& side);
  ~SideFolder();  ///< removes what was not committed
  SideFolder(const SideFolder&) = delete;
  SideFolder& operator=(const SideFolder&) = delete;

  const std::string& path() const noexcept { return part_; }  ///< where to write

  /// Gives it its name.  Throws Error (kMachine).
  void commit() const;

 private:
  std::string folder_;
  std::string part_;
};

/// Whether all images of `side` stand in the house in `folder`.
bool isBaked(const std::string& folder, const PortalSide& side);

}  // namespace enfilade
