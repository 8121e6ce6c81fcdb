#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "app/image_quality.h"
#include "app/methods.h"

namespace enfilade {

/// What a frame took and what went into it.  Empty: the method has no such thing.
struct FrameCost {
  double frametime_ms = 0;        ///< from the pose to the last pixel, reading back not counted
  std::optional<double> cull_ms;  ///< finding what can be seen
  std::optional<double> warp_ms;  ///< warping images
  std::optional<double> composite_ms;    ///< handing the warped pictures over to be drawn
  std::optional<double> draw_ms;         ///< drawing geometry and waiting for the last pixel
  std::optional<std::size_t> triangles;  ///< drawn
  std::optional<std::size_t> cells;      ///< seen
  std::optional<std::size_t> portals;    ///< seen, each side once
  std::optional<std::size_t> portals_as_images;
  std::optional<std::size_t> samples;          ///< warped
  std::optional<std::size_t> samples_clipped;  ///< of the images, left out before warping
  std::optional<double> uncovered_percent;     ///< of the frame's pixels: no sample fell there
  std::optional<double> capture_ms{};          ///< making an image on demand
};

/// A row of frames.csv.
struct FrameRecord {
  Method method = Method::kGeometry;
  std::size_t frame = 0;
  FrameCost cost;
  std::optional<ImageQuality> quality;  ///< against `geometry`
};

/// A measured column of the report.
struct FrameColumn {
  const char* name;          ///< in frames.csv
  const char* summary_name;  ///< in summary.json
  int decimals;
  enum class Tail { kHigh, kLow } tail;  ///< where the bad values are
  std::optional<double> (*value)(const FrameRecord&);
};

/// The columns of frames.csv after `method,frame`, in order.
std::span<const FrameColumn> frameColumns();

}  // namespace enfilade
