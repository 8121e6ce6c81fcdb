#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/limited_images.h"

namespace enfilade {

/// The baked images of a house: read kind by kind when a method first needs them, or, where their
/// bytes are limited, side by side while one walks.
class ImageShelf {
 public:
  /// `most_bytes`: the limit, if there is one.  `house` must outlive it.
  ImageShelf(const House& house, std::string folder, std::optional<std::size_t> most_bytes);

  const PortalImages& images() const noexcept { return limited_ ? limited_->images() : images_; }
  LimitedImages* limited() noexcept { return limited_.get(); }  ///< null: no limit

  /// Reads what `method` shows, if it is not there yet; under a limit it only looks what there is.
  /// Returns whether there is any.  Throws Error (kBadInput) for an image that cannot be read.
  bool fetch(const MethodInfo& method);

  /// See LimitedImages::noteOnTooLarge; of what `method` shows, once it is fetched.
  std::string noteOn(const MethodInfo& method) const;

 private:
  const House& house_;
  std::string folder_;
  PortalImages images_;
  std::unique_ptr<LimitedImages> limited_;
  ImageKinds read_{false, false, false};
};

}  // namespace enfilade
