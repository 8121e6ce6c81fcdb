#include "app/view/frame_history.h"

#include <algorithm>

namespace enfilade {

namespace {

constexpr std::array<FrameStage, kFrameStages> kStages = {{
    {"cull", {0.66f, 0.70f, 0.76f}},
    {"capture", {0.93f, 0.49f, 0.44f}},
    {"load", {0.80f, 0.55f, 0.90f}},
    {"warp", {0.37f, 0.69f, 0.96f}},
    {"composite", {0.25f, 0.78f, 0.59f}},
    {"draw", {0.95f, 0.63f, 0.25f}},
    {"rest", {0.45f, 0.48f, 0.53f}},
}};

}  // namespace

std::span<const FrameStage, kFrameStages> frameStages() { return kStages; }

std::array<double, kFrameStages> stagesOf(const FrameCost& cost) {
  std::array<double, kFrameStages> ms = {cost.cull_ms.value_or(0),
                                         cost.capture_ms.value_or(0),
                                         cost.load_ms.value_or(0),
                                         cost.warp_ms.value_or(0),
                                         cost.composite_ms.value_or(0),
                                         cost.draw_ms.value_or(0),
                                         0};
  double known = 0;
  for (const double stage : ms) known += stage;
  ms.back() = std::max(cost.frametime_ms - known, 0.0);
  return ms;
}

void FrameHistory::add(const FrameCost& cost) {
  if (costs_.size() == kLength) costs_.erase(costs_.begin());
  costs_.push_back(cost);
}

double FrameHistory::medianMs(std::size_t frames) const {
  std::vector<double> times;
  for (std::size_t i = costs_.size() - std::min(frames, costs_.size()); i < costs_.size(); ++i) {
    times.push_back(costs_[i].frametime_ms);
  }
  if (times.empty()) return 0;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace enfilade
