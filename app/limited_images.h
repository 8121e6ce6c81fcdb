#pragma once

#include <map>

#include "app/frame_record.h"
#include "app/image_residence.h"
#include "app/image_store.h"
#include "app/wanted_sides.h"

namespace enfilade {

/// The baked images of a house while one walks, when they may take only so many bytes: those that
/// the walk needs are read in the background before they are shown, and a portal whose image is not
/// there shows geometry.
///
/// A frame is begin(), beginFrame(), shows() …, bringIn(), endFrame(), all by one thread.
class LimitedImages {
 public:
  /// How a frame takes what is read.
  enum class Pace : std::uint8_t {
    kByFrames,   ///< as ImageResidence says, waiting for a reader that is late: the same images in
                 ///< the same frames of a walk, run after run
    kAsItComes,  ///< what is there is shown, nothing is waited for
  };

  LimitedImages(const House& house, std::string folder, std::size_t most_bytes, Pace pace,
                ImageStore::Read read = readSideImages);

  /// See ImageStore::lookAt.
  void lookAt(ImageKind kind) { store_.lookAt(kind); }
  const ImageStore& store() const noexcept { return store_; }
  const PortalImages& images() const noexcept { return store_.images(); }

  /// What `kinds` hold that is never shown, since a side of it alone is more than the limit; empty
  /// if there is none.
  std::string noteOnTooLarge(const ImageKinds& kinds) const;

  /// Begins a walk by `method`, which shows portals' images, with none that it asked for.
  void begin(const MethodInfo& method);

  /// From now on, until begin(), a frame shows what was there in the frame of that number since
  /// begin(), in whatever order they are painted.  Not for what is shown as it comes.
  void repeatFrames() noexcept { repeats_ = true; }

  /// Begins frame number `frame` of the walk by `method`.  Throws what reading its images threw.
  void beginFrame(const MethodInfo& method, std::size_t frame);

  /// Whether the frame may show the images of a side.
  bool shows(std::size_t side) const noexcept { return side < shown_.size() && shown_[side]; }

  /// Waits until what `set` shows as images is there.  Throws what reading it threw.
  void bringIn(const VisibleSet& set);

  /// Ends the frame: asks for what it wants, which may let go of what it showed.  Fills in what
  /// `cost` says of images kept.
  void endFrame(const VisibleSet& set, const glm::vec3& eye, FrameCost& cost);

  /// Whether there is more to come for the frames painted last, if they are painted again.
  bool isLoading() const noexcept;

  /// See ImageStore::complaint.
  std::optional<std::string> complaint() { return store_.complaint(); }

 private:
  /// The walk by one method.
  struct Walked {
    ImageResidence residence;
    std::vector<std::vector<bool>> shown;  ///< by frame and side, to be repeated
    std::uint64_t painted = 0;             ///< the last time
  };

  Walked& walkedBy(const MethodInfo& method);
  bool isRecent(const Walked& walked) const noexcept;
  std::size_t limitForOne() const noexcept;
  void beginPlannedFrame(Walked& walked, std::size_t frame);
  void beginFrameAsItComes(Walked& walked);
  void askFor(const Walked& walked, std::span<const std::size_t> sides);
  std::size_t countLacking() const noexcept;

  const House& house_;
  Pace pace_;
  ImageStore store_;
  std::map<Method, Walked> walked_;
  WantedSides wanted_;  // of the last frame
  std::vector<bool> shown_;
  MethodInfo method_{};  // of the frame at hand
  Walked* now_ = nullptr;
  std::uint64_t painted_ = 0;  // frames, by any method
  bool repeats_ = false;
};

}  // namespace enfilade
