#pragma once

#include <optional>
#include <string>

#include "app/portal_images.h"
#include "app/recency.h"
#include "app/side_reader.h"

namespace enfilade {

/// The images of one kind of one side of a portal.
struct ImageKey {
  std::size_t side = 0;  ///< see sideIndex()
  ImageKind kind = ImageKind::kLdi;
};

/// Images of a house under a limit on their bytes, read in a thread of their own when they are
/// asked for.  What is there and what is being read are together never more than the limit: what
/// was used the longest ago gives way, but nothing that was used in the round at hand.
class ImageStore {
 public:
  /// Reads what stands in `folder` of a side's images of a kind into `images`.
  using Read = std::function<void(const SideFiles& files, ImageKind kind, SideImages& images)>;

  /// `folder`: of `house`, which must outlive it.
  ImageStore(const House& house, std::string folder, std::size_t most_bytes,
             Read read = readSideImages);

  /// Looks at the files of `kind`, if it has not yet.  Before any of the kind is asked for.  Throws
  /// Error (kBadInput) for what lookAtSideImages() finds.
  void lookAt(ImageKind kind);

  /// What stands on the disk of a kind that was looked at.
  const StoredImages& stored(const ImageKey& key) const noexcept { return stored_[indexOf(key)]; }
  std::size_t count(ImageKind kind) const noexcept;  ///< images on the disk

  const PortalImages& images() const noexcept { return images_; }  ///< what is there
  bool isThere(const ImageKey& key) const noexcept { return states_[indexOf(key)] == kThere; }

  /// Begins a round: from now on what is used, and what is asked for, does not give way.
  void beginRound() noexcept { kept_.beginRound(); }
  void use(const ImageKey& key) noexcept { kept_.use(indexOf(key)); }

  /// Has it read, unless it is there, being read, or could not be read before.  What is used in
  /// this round must leave room for it.
  void ask(const ImageKey& key);

  /// Takes in what has been read.
  void takeIn();

  /// Waits until what was asked for is there.  Throws what reading it threw.
  void wait(const ImageKey& key);

  /// Why something could not be read, which is told once.
  std::optional<std::string> complaint();

  std::size_t bytes() const noexcept { return kept_.bytes(); }  ///< there and being read
  std::size_t mostBytes() const noexcept { return most_bytes_; }
  std::size_t reading() const noexcept { return reading_; }  ///< asked for and not there yet

 private:
  enum State : std::uint8_t { kAbsent, kAsked, kThere, kFailed };

  static std::size_t indexOf(const ImageKey& key) noexcept {
    return kAllImageKinds.size() * key.side + static_cast<std::size_t>(key.kind);
  }
  SideImages& imagesOf(std::size_t index) noexcept;
  SideImages readOne(std::size_t index) const;
  void takeIn(std::vector<SideReader::Result> results);
  void drop(std::size_t index);

  const House& house_;
  std::string folder_;
  std::size_t most_bytes_;
  Read read_file_;
  const PortalImages shapes_;  // no images, but as many places for them
  PortalImages images_;
  std::vector<StoredImages> stored_;  // these four by indexOf()
  std::vector<State> states_;
  std::vector<std::exception_ptr> failures_;
  Recency kept_;  // there or being read
  std::array<bool, kAllImageKinds.size()> looked_at_{};
  std::vector<std::string> complaints_;
  std::size_t reading_ = 0;
  SideReader reader_;  // last: its thread uses the rest
};

}  // namespace enfilade
