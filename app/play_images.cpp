#include "app/play_images.h"

#include <fmt/format.h>

#include "scene/error.h"

namespace enfilade {

namespace {

const char* imagesName(ImageKind kind) {
  switch (kind) {
    case ImageKind::kTexture:
      return "portal textures";
    case ImageKind::kReference:
      return "reference images";
    case ImageKind::kLdi:
      return "layered depth images";
  }
  return "images";
}

}  // namespace

PlayImages::PlayImages(const House& house, const std::string& folder,
                       const std::vector<Method>& methods, std::optional<std::size_t> most_bytes) {
  const ImageKinds kinds = imageKindsOf(methods);
  if (most_bytes) {
    limited_ =
        std::make_unique<LimitedImages>(house, folder, *most_bytes, LimitedImages::Pace::kByFrames);
    for (const ImageKind kind : kAllImageKinds) {
      if (kinds.has(kind)) limited_->lookAt(kind);
    }
    note_ = limited_->noteOnTooLarge(kinds);
  } else {
    all_ = PortalImages(house, folder, kinds);
  }
  if (!house.graph.portals.empty()) require(methods, folder);  // else every method draws geometry
}

void PlayImages::require(const std::vector<Method>& methods, const std::string& folder) const {
  for (const Method method : methods) {
    const MethodInfo& info = infoOf(method);
    if (!info.portal_images || count(info.image_kind) > 0) continue;
    throw Error(ErrorKind::kBadInput, folder,
                fmt::format("has no images for the method {}, which shows {}; preprocess the model "
                            "again with --bake {}, or play with --images on-demand",
                            info.name, imagesName(info.image_kind), imageKindNames({})));
  }
}

std::size_t PlayImages::count(ImageKind kind) const noexcept {
  return limited_ ? limited_->store().count(kind) : all_.count(kind);
}

std::size_t PlayImages::count() const noexcept {
  std::size_t sum = 0;
  for (const ImageKind kind : kAllImageKinds) sum += count(kind);
  return sum;
}

}  // namespace enfilade
