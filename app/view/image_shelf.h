#pragma once

#include <string>

#include "app/methods.h"
#include "app/portal_images.h"

namespace enfilade {

/// The baked images of a house, read kind by kind when a method first needs them.
class ImageShelf {
 public:
  ImageShelf(const House& house, std::string folder)
      : house_(house), folder_(std::move(folder)), images_(house) {}

  const PortalImages& images() const noexcept { return images_; }

  /// Reads what `method` shows, if it is not there yet.  Returns whether there is any.  Throws
  /// Error (kBadInput) for an image that cannot be read.
  bool fetch(const MethodInfo& method);

 private:
  const House& house_;
  std::string folder_;
  PortalImages images_;
  ImageKinds read_{false, false, false};
};

}  // namespace enfilade
