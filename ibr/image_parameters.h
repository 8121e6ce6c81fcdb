#pragma once

#include <map>
#include <string>
#include <vector>

#include "ibr/image_kinds.h"

namespace enfilade {

/// Viewpoints on a semicircle beside the main one, at another height.
struct CaptureRing {
  int captures = 0;            ///< [0…180] viewpoints, evenly by angle
  float capture_angle = 0.0f;  ///< [degrees] [0…85] the outermost, from the portal's normal
  float above_eye = 0.0f;      ///< [m] how much higher than the eye
};

/// How the images of a portal are captured.  Lengths in metres.
struct ImageParameters {
  /// Which kinds are baked.  Textures and reference images take more of the disk than the LDIs.
  ImageKinds bake = {false, false, true};
  int image_size =
      256;            ///< [pixels] [16…4096] rows of a capture; columns follow the portal's shape
  int captures = 13;  ///< [1…180] viewpoints along the semicircle
  float capture_angle =
      75.0f;  ///< [degrees] [0…85] the outermost viewpoint, from the portal's normal
  std::vector<CaptureRing> more_rings = {
      {6, 62.5f, -0.5f}};        ///< for what hides under tables; empty: the paper's one ring
  int rays = 2;                  ///< [1…4] rays a pixel of a capture, across and down
  int textures = 13;             ///< [1…180] portal textures a side, evenly along the semicircle
  int references = 6;            ///< [1…180] reference images a side, likewise
  float switch_distance = 1.5f;  ///< [m] [> 0] radius of the semicircle
  float portal_margin = 0.01f;   ///< [m] [≥ 0] captures look this far beyond the portal's edge,
                                 ///< since culling takes a portal for that much larger
  float ldi_half_width = 16.0f;  ///< [portal half widths and heights] [≥ 1] samples beyond are left
                                 ///< out; the LDI's window is what the samples need
  float depth_threshold =
      0.5f;  ///< [pixels] samples whose disparities differ by less show one surface
};

/// The parameters as names with units and values, as a house records them.  A number is written so
/// that it is read as the same number again.
std::map<std::string, std::string> imageParameterTexts(const ImageParameters& parameters);

/// The parameters that a house records; the default for what it does not.  `file` names the house
/// in errors.  Throws Error (kBadInput) for a value that is no number or beyond its limits.
ImageParameters imageParametersFrom(const std::map<std::string, std::string>& texts,
                                    const std::string& file);

}  // namespace enfilade
