#include "app/portal_images.h"

#include "ibr/ldi_file.h"
#include "ibr/portal_side.h"

namespace enfilade {

namespace {

/// The files of one portal side in the folder of a house.
struct SideFolder {
  const House& house;
  const std::string& folder;
  PortalId portal;
  bool from_front;

  bool has(const std::string& file) const {
    return hasFile(house, portalImageName(portal, from_front, file));
  }
  /// What decode(bytes, name for errors) makes of a file that is proved to be the house's.
  template <class Decode>
  auto read(const std::string& file, Decode&& decode) const {
    return decode(readHouseFile(house, folder, portalImageName(portal, from_front, file)),
                  portalImageFolder(folder, portal, from_front) + "/" + file);
  }
};

/// Reads image i into images[i]; the house has all of them, or none.
template <class Images, class Decode>
void readFan(const SideFolder& side, std::string (*file_name)(std::size_t), Images& images,
             Decode&& decode) {
  if (images.empty() || !side.has(file_name(0))) return;
  for (std::size_t i = 0; i < images.size(); ++i) images[i] = side.read(file_name(i), decode);
}

template <class Visit>
void forEachSide(const House& house, Visit&& visit) {
  for (PortalId portal = 0; portal < house.graph.portals.size(); ++portal) {
    for (const bool from_front : {true, false}) visit(portal, from_front);
  }
}

}  // namespace

bool SideImages::has(ImageKind kind) const noexcept { return count(kind) > 0; }

std::size_t SideImages::count(ImageKind kind) const noexcept {
  std::size_t found = 0;
  switch (kind) {
    case ImageKind::kTexture:
      for (std::size_t i = 0; i < textures.size(); ++i) found += hasTexture(i);
      return found;
    case ImageKind::kReference:
      for (std::size_t i = 0; i < references.size(); ++i) found += hasReference(i);
      return found;
    case ImageKind::kLdi:
      return ldi.samples.empty() ? 0 : 1;
  }
  return found;
}

std::size_t SideImages::bytes() const noexcept {
  const auto bytesOf = [](const Ldi& image) {
    return image.samples.size() * sizeof(LdiSample) + image.tiles.size() * sizeof(LdiTile);
  };
  std::size_t sum = bytesOf(ldi);
  for (const Image& texture : textures) sum += texture.rgba.size();
  for (const Ldi& reference : references) sum += bytesOf(reference);
  return sum;
}

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

void PortalImages::read(const House& house, const std::string& folder, const ImageKinds& kinds) {
  forEachSide(house, [&](PortalId id, bool from_front) {
    const SideFolder files{house, folder, id, from_front};
    SideImages& there = side(id, from_front);
    if (kinds.textures) readFan(files, textureFileName, there.textures, decodeImage);
    if (kinds.references) readFan(files, referenceFileName, there.references, decodeLdi);
    if (kinds.ldis && files.has(ldiFileName())) there.ldi = files.read(ldiFileName(), decodeLdi);
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
