#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/contact_sheet.h"
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
  bool quality = false;    ///< compare every frame with `geometry`
  std::string frames_dir;  ///< where to keep frames; empty: nowhere
};

/// Paints every frame of the walk by every method and looks at it, untimed.  With `quality` it
/// fills in what the records say of pictures: that of method m and frame f is records[m · frames +
/// f]. Throws Error (kMachine) when frames cannot be written.
PictureFindings lookAtFrames(FramePainter& painter, const Walk& walk, const PicturePass& pass,
                             const ProgressSink& progress, std::vector<FrameRecord>& records);

}  // namespace enfilade
