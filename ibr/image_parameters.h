#pragma once

namespace enfilade {

/// How the images of a portal are captured.  Lengths in metres.
struct ImageParameters {
  int image_size =
      256;            ///< [pixels] [16…4096] rows of a capture; columns follow the portal's shape
  int captures = 13;  ///< [1…180] viewpoints along the semicircle
  float capture_angle =
      75.0f;  ///< [degrees] [0…85] the outermost viewpoint, from the portal's normal
  float switch_distance = 1.5f;  ///< [m] [> 0] radius of the semicircle
  float ldi_half_width =
      2.0f;  ///< [portal half widths] [≥ 1] how much wider than the portal the LDI's window is
  float depth_threshold =
      1.0f;  ///< [pixels] samples whose disparities differ by less show one surface
};

}  // namespace enfilade
