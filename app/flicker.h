#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/image.h"

namespace enfilade {

/// Where each pixel of a frame was in the frame before: the place of the surface that it shows.
struct FrameMotion {
  int width = 0, height = 0;
  std::vector<glm::vec2>
      before;  ///< [pixels], row 0 on top, centres at halves; x < 0: not in sight
};

/// A camera and the OpenGL depth of the true frame that it sees, row 0 on top.
struct DepthView {
  Camera camera;
  std::vector<float> depth;
};

/// A surface was in sight if in the frame before the depth at its place, in one of the four pixels
/// around it, is its own within 2 %.
FrameMotion motionBetween(const DepthView& before, const DepthView& now, int width, int height);

/// A picture minus the true one, one a pixel: red, green, blue.
using PictureError = std::vector<glm::i16vec3>;

/// Of two pictures of the same size.
void errorOf(const Image& picture, const Image& truth, PictureError& out);

/// How much a frame changes beyond what the true one does [8-bit levels]: the mean, over channels
/// and pixels that were in sight in the frame before, of |(P − P′) − (T − T′)| with P the picture,
/// T the truth, and P′ and T′ the same surface in the frame before (bilinear between pixels).  That
/// is the change of the error along the motion: an error that stays on its surface does not
/// flicker, one that comes, goes or stays on the screen does.  0: it changes as the truth; empty if
/// nothing was in sight.  The same value for any number of threads.
/// Source: the warping error of Lai et al., Learning Blind Video Temporal Consistency, ECCV 2018,
/// less what the true frames themselves come to.
std::optional<double> flicker(const FrameMotion& motion, const PictureError& now,
                              const PictureError& before);

}  // namespace enfilade
