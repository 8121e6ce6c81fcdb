#include "app/limited_images.h"

#include <fmt/format.h>

#include <algorithm>

namespace enfilade {

LimitedImages::LimitedImages(const House& house, std::string folder, std::size_t most_bytes,
                             Pace pace, ImageStore::Read read)
    : house_(house), pace_(pace), store_(house, std::move(folder), most_bytes, std::move(read)) {}

std::string LimitedImages::noteOnTooLarge(const ImageKinds& kinds) const {
  std::size_t count = 0, largest = 0;
  for (std::size_t side = 0; side < 2 * house_.graph.portals.size(); ++side) {
    for (const ImageKind kind : kAllImageKinds) {
      const std::size_t bytes = kinds.has(kind) ? store_.stored({side, kind}).bytes : 0;
      count += bytes > store_.mostBytes();
      largest = std::max(largest, bytes);
    }
  }
  if (count == 0) return {};
  return fmt::format(
      "{} sides of portals always show geometry: their images are larger than "
      "--memory, up to {:.2f} MiB",
      count, static_cast<double>(largest) / (1 << 20));
}

LimitedImages::Walked& LimitedImages::walkedBy(const MethodInfo& method) {
  const auto found = walked_.find(method.method);
  if (found != walked_.end()) return found->second;
  store_.lookAt(method.image_kind);
  std::vector<std::size_t> bytes;
  for (std::size_t side = 0; side < 2 * house_.graph.portals.size(); ++side) {
    bytes.push_back(store_.stored({side, method.image_kind}).bytes);
  }
  Walked walked{ImageResidence(std::move(bytes), store_.mostBytes()), {}, 0};
  return walked_.emplace(method.method, std::move(walked)).first->second;
}

void LimitedImages::begin(const MethodInfo& method) {
  repeats_ = false;
  walked_.erase(method.method);
  walkedBy(method);
}

/// Whether it is painted in turn with others.
bool LimitedImages::isRecent(const Walked& walked) const noexcept {
  constexpr std::uint64_t kTurns = 4;
  return walked.painted > 0 && walked.painted + kTurns > painted_;
}

/// Methods that are shown at once share the limit.  Those that are played one after another have
/// it to themselves, so that a walk by one is the same whatever else is played.
std::size_t LimitedImages::limitForOne() const noexcept {
  if (pace_ == Pace::kByFrames) return store_.mostBytes();
  const auto at_once = std::count_if(walked_.begin(), walked_.end(),
                                     [&](const auto& entry) { return isRecent(entry.second); });
  return store_.mostBytes() / static_cast<std::size_t>(at_once);
}

void LimitedImages::beginPlannedFrame(Walked& walked, std::size_t frame) {
  if (repeats_) {
    shown_ = frame < walked.shown.size() ? walked.shown[frame] : std::vector<bool>();
    return;
  }
  store_.beginRound();
  for (const std::size_t side : walked.residence.beginFrame()) {
    store_.ask({side, method_.image_kind});  // another method's images may have taken its place
    store_.wait({side, method_.image_kind});
  }
  for (std::size_t side = 0; side < shown_.size(); ++side) {
    shown_[side] = walked.residence.isThere(side);
  }
  if (walked.shown.size() <= frame) walked.shown.resize(frame + 1);
  walked.shown[frame] = shown_;
}

void LimitedImages::beginFrameAsItComes(Walked& walked) {
  store_.takeIn();
  walked.residence.beginFrame();
  for (std::size_t side = 0; side < shown_.size(); ++side) {
    shown_[side] = store_.isThere({side, method_.image_kind});
  }
}

void LimitedImages::beginFrame(const MethodInfo& method, std::size_t frame) {
  method_ = method;
  now_ = &walkedBy(method);
  now_->painted = ++painted_;
  shown_.assign(2 * house_.graph.portals.size(), false);
  if (pace_ == Pace::kByFrames) {
    beginPlannedFrame(*now_, frame);
  } else {
    beginFrameAsItComes(*now_);
  }
}

void LimitedImages::bringIn(const VisibleSet& set) {
  if (pace_ == Pace::kAsItComes) return;
  const auto forEachShown = [&](auto&& act) {
    for (const VisiblePortal& visible : set.portals) {
      if (!visible.as_image) continue;
      act(ImageKey{sideIndex(visible.portal, visible.from_front), method_.image_kind});
    }
  };
  store_.beginRound();
  forEachShown([&](const ImageKey& key) { store_.use(key); });
  forEachShown([&](const ImageKey& key) { store_.ask(key); });
  forEachShown([&](const ImageKey& key) { store_.wait(key); });
}

void LimitedImages::askFor(const Walked& walked, std::span<const std::size_t> sides) {
  store_.beginRound();
  for (std::size_t side = 0; side < walked.residence.sides(); ++side) {
    if (walked.residence.keeps(side)) store_.use({side, method_.image_kind});
  }
  for (const std::size_t side : sides) store_.ask({side, method_.image_kind});
  if (pace_ == Pace::kByFrames) return;
  // What a method shown beside this one has displaced.
  for (const std::size_t side : wanted_.sides) {
    if (walked.residence.keeps(side)) store_.ask({side, method_.image_kind});
  }
}

std::size_t LimitedImages::countLacking() const noexcept {
  const std::span in_view(wanted_.sides.data(), wanted_.in_view);
  return static_cast<std::size_t>(
      std::count_if(in_view.begin(), in_view.end(), [&](std::size_t side) {
        return !shown_[side] && store_.stored({side, method_.image_kind}).bytes > 0;
      }));
}

void LimitedImages::endFrame(const VisibleSet& set, const glm::vec3& eye, FrameCost& cost) {
  findWantedSides(house_, set, eye, wanted_);
  cost.portals_lacking_image = countLacking();
  // Nobody waits in a window: frames faster than the disk would take back what is being read.
  constexpr std::size_t kAtOnce = 2;
  const bool busy = pace_ == Pace::kAsItComes && store_.reading() >= kAtOnce;
  if (!repeats_ && !busy) {
    now_->residence.setLimit(limitForOne());
    askFor(*now_, now_->residence.endFrame(wanted_.sides));
  }
  cost.image_bytes = now_->residence.bytes();
}

bool LimitedImages::isLoading() const noexcept {
  if (store_.reading() > 0) return true;
  return std::any_of(walked_.begin(), walked_.end(), [&](const auto& entry) {
    return isRecent(entry.second) && !entry.second.residence.satisfied();
  });
}

}  // namespace enfilade
