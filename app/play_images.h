#pragma once

#include <memory>
#include <optional>

#include "app/limited_images.h"

namespace enfilade {

/// The baked images that the methods of a playback show: all of them in memory, or as many as a
/// limit lets.
class PlayImages {
 public:
  /// None.
  PlayImages() = default;

  /// Those that stand in `folder`, of `house`, which must outlive it.  `most_bytes`: the limit, if
  /// there is one.  Throws Error (kBadInput) for an image that cannot be read, and for a method
  /// that has none.
  PlayImages(const House& house, const std::string& folder, const std::vector<Method>& methods,
             std::optional<std::size_t> most_bytes);

  const PortalImages& images() const noexcept { return limited_ ? limited_->images() : all_; }
  LimitedImages* limited() noexcept { return limited_.get(); }  ///< null: no limit

  std::size_t count(ImageKind kind) const noexcept;  ///< of the house, of those that are shown
  std::size_t count() const noexcept;

  const std::string& note() const noexcept { return note_; }  ///< for the user; empty: none

 private:
  void require(const std::vector<Method>& methods, const std::string& folder) const;

  PortalImages all_;
  std::unique_ptr<LimitedImages> limited_;
  std::string note_;
};

}  // namespace enfilade
