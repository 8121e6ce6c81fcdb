#include "app/portal_images.h"

#include <fmt/format.h>

#include "app/machine_info.h"
#include "ibr/portal_side.h"
#include "scene/error.h"

namespace enfilade {

namespace {

template <class Visit>
void forEachSide(const House& house, Visit&& visit) {
  for (PortalId portal = 0; portal < house.graph.portals.size(); ++portal) {
    for (const bool from_front : {true, false}) visit(portal, from_front);
  }
}

}  // namespace

PortalImages::PortalImages(const House& house) {
  const ImageParameters parameters = imageParametersFrom(house.info.parameters, "house.json");
  sides_.resize(2 * house.graph.portals.size());
  forEachSide(house, [&](PortalId id, bool from_front) {
    const Portal& portal = house.graph.portals[id];
    if (!getsImage(portal, from_front)) return;
    const float eye_y = eyeLevelBefore(house.graph, portal, from_front, house.eye_height);
    const auto fan = [&](int count) {
      return ViewpointFan(portal, from_front, eye_y, parameters, count);
    };
    SideImages& images = side(id, from_front);
    images.texture_fan = fan(parameters.textures);
    images.reference_fan = fan(parameters.references);
    images.textures.resize(images.texture_fan.size());
    images.references.resize(images.reference_fan.size());
  });
}

PortalImages::PortalImages(const House& house, const std::string& folder, const ImageKinds& kinds)
    : PortalImages(house) {
  read(house, folder, kinds);
}

void PortalImages::requireMemory(const House& house, const std::string& folder,
                                 const ImageKinds& kinds, std::uint64_t machine) const {
  std::uint64_t bytes = 0;
  forEachSide(house, [&](PortalId id, bool from_front) {
    for (const ImageKind kind : kAllImageKinds) {
      if (!kinds.has(kind)) continue;
      try {
        bytes +=
            lookAtSideImages({house, folder, id, from_front}, kind, side(id, from_front)).bytes;
      } catch (const Error&) {
        // Reading it says what is wrong with it.
      }
    }
  });
  if (bytes <= machine) return;
  throw Error(ErrorKind::kMachine, folder,
              fmt::format("its images take {} MiB of memory, and this machine has {}: limit them "
                          "by --memory",
                          bytes >> 20, machine >> 20));
}

void PortalImages::read(const House& house, const std::string& folder, const ImageKinds& kinds) {
  requireMemory(house, folder, kinds, machineMemory());
  forEachSide(house, [&](PortalId id, bool from_front) {
    for (const ImageKind kind : kAllImageKinds) {
      if (kinds.has(kind))
        readSideImages({house, folder, id, from_front}, kind, side(id, from_front));
    }
  });
}

const SideImages& PortalImages::side(PortalId portal, bool from_front) const noexcept {
  static const SideImages none;
  const std::size_t index = sideIndex(portal, from_front);
  return index < sides_.size() ? sides_[index] : none;
}

SideImages& PortalImages::side(PortalId portal, bool from_front) noexcept {
  return sides_[sideIndex(portal, from_front)];
}

std::size_t PortalImages::count(ImageKind kind) const noexcept {
  std::size_t sum = 0;
  for (const SideImages& images : sides_) sum += images.count(kind);
  return sum;
}

std::size_t PortalImages::count() const noexcept {
  return count(ImageKind::kTexture) + count(ImageKind::kReference) + count(ImageKind::kLdi);
}

ImageCounts countImages(const House& house) {
  ImageCounts counts;
  forEachSide(house, [&](PortalId portal, bool from_front) {
    const auto has = [&](const std::string& file) {
      return hasFile(house, portalImageName(portal, from_front, file));
    };
    const auto consecutive = [&](std::string (*file_name)(std::size_t)) {
      std::size_t count = 0;
      while (has(file_name(count))) ++count;
      return count;
    };
    const std::size_t textures = consecutive(textureFileName);
    const std::size_t references = consecutive(referenceFileName);
    const std::size_t ldis = has(ldiFileName());
    counts.textures += textures;
    counts.references += references;
    counts.ldis += ldis;
    counts.sides += textures + references + ldis > 0;
  });
  return counts;
}

}  // namespace enfilade
