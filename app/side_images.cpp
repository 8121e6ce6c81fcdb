#include "app/side_images.h"

#include "ibr/ldi_file.h"
#include "portals/house_files.h"

namespace enfilade {

namespace {

/// The names of the images of `kind` in a side's folder; the house has all of them, or none.
std::vector<std::string> imageNames(const SideFiles& files, ImageKind kind,
                                    const SideImages& images) {
  std::vector<std::string> names;
  if (kind == ImageKind::kLdi) {
    names.push_back(ldiFileName());
  } else {
    const bool textures = kind == ImageKind::kTexture;
    const std::size_t count = textures ? images.textures.size() : images.references.size();
    for (std::size_t i = 0; i < count; ++i) {
      names.push_back(textures ? textureFileName(i) : referenceFileName(i));
    }
  }
  const auto isListed = [&](const std::string& name) {
    return hasFile(files.house, portalImageName(files.portal, files.from_front, name));
  };
  if (names.empty() || !isListed(names.front())) return {};
  return names;
}

std::string pathOf(const SideFiles& files, const std::string& name) {
  return portalImageFolder(files.folder, files.portal, files.from_front) + "/" + name;
}

/// What decode(bytes, path for errors) makes of a file that is proved to be the house's.
template <class Decode>
auto readProved(const SideFiles& files, const std::string& name, Decode&& decode) {
  return decode(readHouseFile(files.house, files.folder,
                              portalImageName(files.portal, files.from_front, name)),
                pathOf(files, name));
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
  const auto bytesOf = [](const Ldi& image) { return image.samples.empty() ? 0 : ldiBytes(image); };
  std::size_t sum = bytesOf(ldi);
  for (const Image& texture : textures) sum += texture.rgba.size();
  for (const Ldi& reference : references) sum += bytesOf(reference);
  return sum;
}

void SideImages::swap(ImageKind kind, SideImages& other) noexcept {
  switch (kind) {
    case ImageKind::kTexture:
      return std::swap(textures, other.textures);
    case ImageKind::kReference:
      return std::swap(references, other.references);
    case ImageKind::kLdi:
      return std::swap(ldi, other.ldi);
  }
}

void readSideImages(const SideFiles& files, ImageKind kind, SideImages& images) {
  const std::vector<std::string> names = imageNames(files, kind, images);
  for (std::size_t i = 0; i < names.size(); ++i) {
    switch (kind) {
      case ImageKind::kTexture:
        images.textures[i] = readProved(files, names[i], decodeImage);
        break;
      case ImageKind::kReference:
        images.references[i] = readProved(files, names[i], decodeLdi);
        break;
      case ImageKind::kLdi:
        images.ldi = readProved(files, names[i], decodeLdi);
        break;
    }
  }
}

StoredImages lookAtSideImages(const SideFiles& files, ImageKind kind, const SideImages& images) {
  StoredImages stored;
  for (const std::string& name : imageNames(files, kind, images)) {
    ++stored.count;
    if (kind == ImageKind::kTexture) {
      const glm::ivec2 size = readImageSize(pathOf(files, name));
      stored.bytes +=
          std::size_t{4} * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    } else {
      stored.bytes += ldiBytesOfFile(pathOf(files, name));
    }
  }
  return stored;
}

}  // namespace enfilade
