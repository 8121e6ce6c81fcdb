#include "app/view/image_shelf.h"

namespace enfilade {

ImageShelf::ImageShelf(const House& house, std::string folder,
                       std::optional<std::size_t> most_bytes)
    : house_(house), folder_(std::move(folder)), images_(house) {
  if (!most_bytes) return;
  limited_ = std::make_unique<LimitedImages>(house_, folder_, *most_bytes,
                                             LimitedImages::Pace::kAsItComes);
}

bool ImageShelf::fetch(const MethodInfo& method) {
  if (!method.portal_images) return true;
  if (limited_) {
    limited_->lookAt(method.image_kind);
    return limited_->store().count(method.image_kind) > 0;
  }
  const ImageKinds wanted = imageKindsOf({&method.method, 1});
  if (!read_.has(method.image_kind)) images_.read(house_, folder_, wanted);
  read_.textures |= wanted.textures;
  read_.references |= wanted.references;
  read_.ldis |= wanted.ldis;
  return images_.count(method.image_kind) > 0;
}

std::string ImageShelf::noteOn(const MethodInfo& method) const {
  return limited_ ? limited_->noteOnTooLarge(imageKindsOf({&method.method, 1})) : std::string();
}

}  // namespace enfilade
