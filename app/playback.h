#pragma once

#include <string>
#include <vector>

#include "app/frame_files.h"
#include "app/quality_pass.h"

namespace enfilade {

struct PlaybackParameters {
  std::vector<Method> methods;
  int warm_up = 3;         ///< [≥ 0] frames painted before the first that counts, for each method
  bool quality = false;    ///< compare every frame with `geometry`
  std::string frames_dir;  ///< where to keep frames as METHOD/frame-00000.png; empty: nowhere
  PictureKeeper keeper = {};  ///< keeps small pictures
  bool in_order = false;      ///< what a frame shows depends on those before it
};

struct Playback {
  std::vector<FrameRecord> records;  ///< method after method, each with all frames
  PictureFindings findings;          ///< with `quality`
};

/// Plays the walk by each method in turn, and returns a record for each method and frame.  Every
/// method has a pass of its own in which nothing but its frames is painted and timed; pictures are
/// compared and kept in a second pass.  Throws Error (kMachine)
/// when frames cannot be written.
Playback playBack(FramePainter& painter, const Walk& walk, const PlaybackParameters& parameters,
                  const ProgressSink& progress);

}  // namespace enfilade
