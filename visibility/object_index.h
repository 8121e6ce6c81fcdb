#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "portals/house.h"
#include "portals/open_doors.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// Objects found, and the memory to find more: kept by who asks each frame.
struct ObjectList {
  std::vector<std::uint32_t> objects;  ///< increasing
  std::vector<std::uint8_t> seen;      ///< scratch
};

/// Which objects stand in which cell, and where: made once for a house, asked each frame.
/// Doors that stand open (see openDoors()) are left out.
class ObjectIndex {
 public:
  /// `house` need not outlive it.
  explicit ObjectIndex(const House& house);

  /// Draws the doors as they stand now: `house` is the same but for which portals are active.
  void setDoors(const House& house);

  /// The objects to draw, increasing: of the visible cells, those whose box may be seen through one
  /// of the cell's regions.  Conservative.
  std::vector<std::uint32_t> visible(const VisibleSet& set) const;

  /// The same into `list`; allocates nothing when it was asked before.
  void visible(const VisibleSet& set, ObjectList& list) const;

  /// The objects to draw without any culling but that by the view frustum, increasing.
  /// Conservative.
  std::vector<std::uint32_t> inFrustum(const View& view) const;
  void inFrustum(const View& view, ObjectList& list) const;

  /// The objects that the cell can see, increasing, doors among them that may be shut.  A door is
  /// seen from both sides of its portal, beyond which it may stand.
  std::span<const std::uint32_t> ofCell(CellId cell) const noexcept;

  /// The leaves of all doors, and one flag an object: a door that stands open now.
  std::span<const DoorLeaf> leaves() const noexcept { return leaves_; }
  std::span<const std::uint8_t> openDoors() const noexcept { return open_; }

  /// The box of every object [m, world], doors too.
  std::span<const Box> bounds() const noexcept { return bounds_; }

 private:
  std::vector<Box> bounds_;  // one an object
  std::vector<DoorLeaf> leaves_;
  std::vector<std::uint8_t> open_;    // one an object: a door that stands open
  std::vector<std::uint32_t> drawn_;  // every object but open doors, increasing
  std::vector<std::uint32_t> first_;  // one a cell and one more, into cell_objects_
  std::vector<std::uint32_t> cell_objects_;
};

}  // namespace enfilade
