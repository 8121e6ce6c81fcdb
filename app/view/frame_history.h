#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "app/frame_record.h"

namespace enfilade {

/// A part of a frame's time.
struct FrameStage {
  const char* name;
  std::array<float, 3> color;  ///< sRGB
};

/// cull, capture, warp, composite, draw, rest.
inline constexpr std::size_t kFrameStages = 7;
std::span<const FrameStage, kFrameStages> frameStages();

/// How a frame's time splits [ms]; their sum is the frame's time.
std::array<double, kFrameStages> stagesOf(const FrameCost& cost);

/// What the frames of late cost.
class FrameHistory {
 public:
  static constexpr std::size_t kLength = 240;

  void add(const FrameCost& cost);
  void clear() { costs_.clear(); }

  bool empty() const noexcept { return costs_.empty(); }
  const FrameCost& last() const { return costs_.back(); }
  std::span<const FrameCost> costs() const noexcept { return costs_; }  ///< oldest first

  /// The median frame time of the last `frames` [ms]; 0 without any.
  double medianMs(std::size_t frames) const;

 private:
  std::vector<FrameCost> costs_;
};

}  // namespace enfilade
