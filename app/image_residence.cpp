#include "app/image_residence.h"

#include <algorithm>
#include <cassert>

namespace enfilade {

namespace {

/// [bytes a frame] How fast a reader is taken to be: images of 450 MiB a second come out of files
/// that the system has in memory (one core of an AMD EPYC), so that it has 4 ms of a frame to do.
constexpr std::size_t kBytesAFrame = std::size_t{2} << 20;

/// [frames] No more is asked for beforehand than is there within so many, since what is wanted
/// changes meanwhile.
constexpr std::uint64_t kAhead = 4;

}  // namespace

ImageResidence::ImageResidence(std::vector<std::size_t> bytes, std::size_t most_bytes)
    : bytes_(std::move(bytes)),
      most_bytes_(most_bytes),
      kept_(bytes_.size()),
      there_from_(bytes_.size(), 0) {}

std::span<const std::size_t> ImageResidence::beginFrame() {
  ++frame_;
  arrived_.clear();
  for (const std::size_t side : coming_) {
    if (isThere(side)) arrived_.push_back(side);
  }
  std::erase_if(coming_, [&](std::size_t side) { return !kept_.keeps(side) || isThere(side); });
  return arrived_;
}

/// Marks the sides that fit as wanted, and lists those of them that are not kept.
void ImageResidence::findMissing(std::span<const std::size_t> sides) {
  missing_.clear();
  std::size_t room = most_bytes_;
  for (const std::size_t side : sides) {
    if (bytes_[side] == 0 || bytes_[side] > room) continue;
    room -= bytes_[side];
    kept_.use(side);
    if (!kept_.keeps(side)) missing_.push_back(side);
  }
}

/// What is wanted fits, so there is always something else to give way.
void ImageResidence::makeRoomFor(std::size_t bytes) {
  while (kept_.bytes() + bytes > most_bytes_) {
    const std::size_t side = kept_.leastRecent();
    assert(side != Recency::kNone);
    kept_.keep(side, 0);
  }
}

std::span<const std::size_t> ImageResidence::endFrame(std::span<const std::size_t> sides) {
  kept_.beginRound();
  findMissing(sides);
  makeRoomFor(0);
  asked_.clear();
  const bool first = frame_ == 1;
  for (const std::size_t side : missing_) {
    if (last_arrival_ > frame_ + kAhead) break;
    makeRoomFor(bytes_[side]);
    kept_.keep(side, bytes_[side]);
    if (!first) last_arrival_ = std::max(last_arrival_, frame_) + 1 + bytes_[side] / kBytesAFrame;
    there_from_[side] = std::max(last_arrival_, frame_ + 1);
    coming_.push_back(side);
    asked_.push_back(side);
  }
  satisfied_ = asked_.size() == missing_.size();
  return asked_;
}

}  // namespace enfilade
