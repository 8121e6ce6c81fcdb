#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/contact_sheet.h"
#include "app/picture_keeper.h"
#include "app/switch_jump.h"
#include "app/walk.h"
#include "preprocess/progress.h"

namespace enfilade {

/// What the pictures of a walk are compared for, besides the columns of its records.
struct PictureFindings {
  std::vector<SwitchJump> jumps;      ///< method after method, in the order of frames
  std::optional<ContactSheet> sheet;  ///< none without a method that shows portal images
};

/// What to do with the frames of a walk.
struct PicturePass {
  std::vector<Method> methods;
  bool quality = false;       ///< compare every frame with `geometry`
  std::string frames_dir;     ///< where to keep frames; empty: nowhere
  PictureKeeper keeper = {};  ///< keeps small pictures
  bool in_order = false;      ///< what a frame shows depends on those before it: paint all of them

  /// Whether every frame is painted, not only those that are kept small.
  bool everyFrame() const { return quality || in_order || !frames_dir.empty(); }
};

/// Paints the frames of the walk by every method and looks at them, untimed.  With `quality` it
/// fills in what the records say of pictures: that of method m and frame f is records[m · frames +
/// f]. Throws Error (kMachine) when frames cannot be written.
PictureFindings lookAtFrames(FramePainter& painter, const Walk& walk, const PicturePass& pass,
                             const ProgressSink& progress, std::vector<FrameRecord>& records);

}  // namespace enfilade
