#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ibr/ldi.h"
#include "portals/house.h"

namespace enfilade {

/// The layered depth images of a house in memory: one for each portal side that has one.
class PortalImages {
 public:
  PortalImages() = default;
  /// Reads what stands under `folder`.  Throws Error (kBadInput) for an image that cannot be read.
  PortalImages(const House& house, const std::string& folder);

  /// What a viewer on that side sees through the portal; null: there is no image.
  const Ldi* find(PortalId portal, bool from_front) const noexcept;
  std::size_t count() const noexcept { return count_; }

 private:
  std::vector<std::optional<Ldi>> sides_;  ///< index 2 · portal + (from_front ? 0 : 1)
  std::size_t count_ = 0;
};

}  // namespace enfilade
