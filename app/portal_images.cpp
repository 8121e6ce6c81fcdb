#include "app/portal_images.h"

#include <filesystem>

#include "ibr/ldi_file.h"

namespace enfilade {

PortalImages::PortalImages(const House& house, const std::string& folder) {
  sides_.resize(2 * house.graph.portals.size());
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const std::string file =
        portalImageFolder(folder, static_cast<PortalId>(side / 2), side % 2 == 0) + "/ldi.bin";
    if (!std::filesystem::exists(file)) continue;
    sides_[side] = readLdi(file);
    ++count_;
  }
}

const Ldi* PortalImages::find(PortalId portal, bool from_front) const noexcept {
  const std::size_t side = 2 * static_cast<std::size_t>(portal) + (from_front ? 0 : 1);
  if (side >= sides_.size() || !sides_[side]) return nullptr;
  return &*sides_[side];
}

}  // namespace enfilade
