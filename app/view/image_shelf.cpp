#include "app/view/image_shelf.h"

namespace enfilade {

bool ImageShelf::fetch(const MethodInfo& method) {
  if (!method.portal_images) return true;
  ImageKinds wanted{false, false, false};
  bool ImageKinds::*const kind = method.image_kind == ImageKind::kTexture ? &ImageKinds::textures
                                 : method.image_kind == ImageKind::kReference
                                     ? &ImageKinds::references
                                     : &ImageKinds::ldis;
  wanted.*kind = true;
  if (!(read_.*kind)) images_.read(house_, folder_, wanted);
  read_.*kind = true;
  return images_.count(method.image_kind) > 0;
}

}  // namespace enfilade
