#include "app/image_store.h"

#include <cassert>
#include <utility>

namespace enfilade {

namespace {

ImageKind kindOf(std::size_t index) { return kAllImageKinds[index % kAllImageKinds.size()]; }
std::size_t sideOf(std::size_t index) { return index / kAllImageKinds.size(); }
PortalId portalOf(std::size_t index) { return static_cast<PortalId>(sideOf(index) / 2); }
bool fromFront(std::size_t index) { return sideOf(index) % 2 == 0; }

}  // namespace

ImageStore::ImageStore(const House& house, std::string folder, std::size_t most_bytes, Read read)
    : house_(house),
      folder_(std::move(folder)),
      most_bytes_(most_bytes),
      read_file_(std::move(read)),
      shapes_(house),
      images_(shapes_),
      stored_(2 * kAllImageKinds.size() * house.graph.portals.size()),
      states_(stored_.size(), kAbsent),
      failures_(stored_.size()),
      kept_(stored_.size()),
      reader_([this](std::size_t index) { return readOne(index); }) {}

void ImageStore::lookAt(ImageKind kind) {
  if (std::exchange(looked_at_[static_cast<std::size_t>(kind)], true)) return;
  for (std::size_t side = 0; side < 2 * house_.graph.portals.size(); ++side) {
    const std::size_t index = indexOf({side, kind});
    stored_[index] = lookAtSideImages({house_, folder_, portalOf(index), fromFront(index)}, kind,
                                      shapes_.side(portalOf(index), fromFront(index)));
  }
}

std::size_t ImageStore::count(ImageKind kind) const noexcept {
  std::size_t sum = 0;
  for (std::size_t side = 0; side < 2 * house_.graph.portals.size(); ++side) {
    sum += stored({side, kind}).count;
  }
  return sum;
}

SideImages& ImageStore::imagesOf(std::size_t index) noexcept {
  return images_.side(portalOf(index), fromFront(index));
}

/// In the reader's thread: touches nothing that changes.
SideImages ImageStore::readOne(std::size_t index) const {
  SideImages images = shapes_.side(portalOf(index), fromFront(index));
  read_file_({house_, folder_, portalOf(index), fromFront(index)}, kindOf(index), images);
  return images;
}

void ImageStore::drop(std::size_t index) {
  if (states_[index] == kAsked) {
    reader_.takeBack(index);
    --reading_;
  } else {
    SideImages given_up = shapes_.side(portalOf(index), fromFront(index));
    imagesOf(index).swap(kindOf(index), given_up);
    reader_.free(std::move(given_up));
  }
  states_[index] = kAbsent;
  kept_.keep(index, 0);
}

void ImageStore::ask(const ImageKey& key) {
  const std::size_t index = indexOf(key);
  kept_.use(index);
  if (states_[index] != kAbsent || stored_[index].bytes == 0) return;
  while (kept_.bytes() + stored_[index].bytes > most_bytes_) {
    const std::size_t least = kept_.leastRecent();
    assert(least != Recency::kNone);
    drop(least);
  }
  kept_.keep(index, stored_[index].bytes);
  states_[index] = kAsked;
  ++reading_;
  reader_.ask(index);
}

void ImageStore::takeIn() { takeIn(reader_.results()); }

void ImageStore::takeIn(std::vector<SideReader::Result> results) {
  for (SideReader::Result& result : results) {
    const std::size_t index = result.asked;
    assert(states_[index] == kAsked);
    --reading_;
    states_[index] = result.failure ? kFailed : kThere;
    if (!result.failure) {
      imagesOf(index).swap(kindOf(index), result.images);
      continue;
    }
    kept_.keep(index, 0);
    failures_[index] = result.failure;
    try {
      std::rethrow_exception(result.failure);
    } catch (const std::exception& error) {
      complaints_.emplace_back(error.what());
    }
  }
}

void ImageStore::wait(const ImageKey& key) {
  const std::size_t index = indexOf(key);
  while (states_[index] == kAsked) takeIn(reader_.waitForSome());
  if (states_[index] == kFailed) std::rethrow_exception(failures_[index]);
}

std::optional<std::string> ImageStore::complaint() {
  if (complaints_.empty()) return std::nullopt;
  std::string first = complaints_.front();
  complaints_.erase(complaints_.begin());
  return first;
}

}  // namespace enfilade
