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
  double frametime_ms = 0;           ///< from the pose to the last pixel, reading back not counted
  std::optional<double> cull_ms;     ///< finding what can be seen
  std::optional<double> capture_ms;  ///< making an image on demand
  std::optional<double> warp_ms;     ///< warping images
  std::optional<double> composite_ms;    ///< handing the warped pictures over to be drawn
  std::optional<double> draw_ms;         ///< drawing geometry and waiting for the last pixel
  std::optional<std::size_t> triangles;  ///< handed to OpenGL
  std::optional<std::size_t> cells;      ///< seen
  std::optional<std::size_t> portals;    ///< seen, each side once
  std::optional<std::size_t> portals_as_images;
  std::optional<std::size_t> samples;          ///< warped
  std::optional<std::size_t> samples_clipped;  ///< of the images, left out before warping
  /// Of the frame's pixels [percent], those that no sample fell into before any filling.  Once the
  /// pictures were compared: only pixels that show a portal's image; until then also what hides it.
  std::optional<double> uncovered_percent;
  // Under a limit on the memory for images:
  std::optional<double> load_ms;  ///< asking for images, waiting for one that is late
  /// Seen from so far that they would show an image of the house that is not in memory.
  std::optional<std::size_t> portals_lacking_image;
  std::optional<std::size_t> image_bytes;  ///< of images in memory or being read
};

/// A row of frames.csv.
struct FrameRecord {
  Method method = Method::kGeometry;
  std::size_t frame = 0;
  FrameCost cost;
  std::optional<ImageQuality> quality = {};  ///< against `geometry`
  std::optional<double> flicker =
      {};  ///< [8-bit levels] against `geometry`; not of the first frame
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
