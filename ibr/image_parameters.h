#pragma once

#include <vector>

namespace enfilade {

/// Viewpoints on a semicircle beside the main one, at another height.
struct CaptureRing {
  int captures = 0;            ///< [0…180] viewpoints, evenly by angle
  float capture_angle = 0.0f;  ///< [degrees] [0…85] the outermost, from the portal's normal
  float above_eye = 0.0f;      ///< [m] how much higher than the eye
};

/// How the images of a portal are captured.  Lengths in metres.
struct ImageParameters {
  int image_size =
      256;            ///< [pixels] [16…4096] rows of a capture; columns follow the portal's shape
  int captures = 13;  ///< [1…180] viewpoints along the semicircle
  float capture_angle =
      75.0f;  ///< [degrees] [0…85] the outermost viewpoint, from the portal's normal
  std::vector<CaptureRing> more_rings = {
      {6, 62.5f, -0.5f}};        ///< for what hides under tables; empty: the paper's one ring
  int rays = 2;                  ///< [1…4] rays a pixel of a capture, across and down
  float switch_distance = 1.5f;  ///< [m] [> 0] radius of the semicircle
  float portal_margin = 0.01f;   ///< [m] [≥ 0] captures look this far beyond the portal's edge,
                                 ///< since culling takes a portal for that much larger
  float ldi_half_width = 16.0f;  ///< [portal half widths and heights] [≥ 1] samples beyond are left
                                 ///< out; the LDI's window is what the samples need
  float depth_threshold =
      0.5f;  ///< [pixels] samples whose disparities differ by less show one surface
};

}  // namespace enfilade
