#pragma once

#include <span>
#include <vector>

#include "app/recency.h"

namespace enfilade {

/// Decides which portal sides have their images in memory in each frame of a walk, when not all of
/// them may.  By the frames alone, so that the same walk has the same images in the same frames
/// whatever the disk and the threads do: a side that is asked for is there some frames later, as
/// many as a reader of fixed speed takes for it and for what was asked for before.  What the first
/// frame asks for is there in the second.
///
/// What is there and what is being read are together never more than the limit.  The sides wanted
/// the longest ago give way first, but none that is wanted now and fits.
class ImageResidence {
 public:
  /// `bytes`: one number a side, that its images take; 0: it has none.
  ImageResidence(std::vector<std::size_t> bytes, std::size_t most_bytes);

  /// Begins the next frame.  Returns the sides that are there from now on.
  std::span<const std::size_t> beginFrame();

  /// Whether the side's images are there in this frame.
  bool isThere(std::size_t side) const noexcept {
    return kept_.keeps(side) && there_from_[side] <= frame_;
  }

  /// Ends a frame that wants `sides`, the most urgent first: asks for those that fit and are not
  /// there.  Returns what is to be read from now on, in order.
  std::span<const std::size_t> endFrame(std::span<const std::size_t> sides);

  void setLimit(std::size_t most_bytes) noexcept { most_bytes_ = most_bytes; }

  /// Whether all that the last frame wanted, and that fits, is kept or being read.
  bool satisfied() const noexcept { return satisfied_; }

  bool keeps(std::size_t side) const noexcept { return kept_.keeps(side); }  ///< or is read
  std::size_t bytes() const noexcept { return kept_.bytes(); }  ///< there and being read
  std::size_t sides() const noexcept { return bytes_.size(); }

 private:
  void findMissing(std::span<const std::size_t> sides);
  void makeRoomFor(std::size_t bytes);

  std::vector<std::size_t> bytes_;
  std::size_t most_bytes_;
  Recency kept_;                           // there or being read
  std::vector<std::uint64_t> there_from_;  // frames
  std::vector<std::size_t> missing_, asked_, arrived_, coming_;
  std::uint64_t frame_ = 0, last_arrival_ = 0;
  bool satisfied_ = true;
};

}  // namespace enfilade
