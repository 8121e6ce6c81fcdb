#pragma once

#include <map>
#include <string>
#include <vector>

#include "ibr/image_kinds.h"

namespace enfilade {

/// Viewpoints on a semicircle before a portal, all at one height.
struct CaptureRing {
  int captures = 13;       ///< [1…180] viewpoints, evenly by angle
  float angle = 75.0f;     ///< [degrees] [0…85] the outermost, from the portal's normal
  float above_eye = 0.0f;  ///< [m] [−3…3] how much higher than the eye
};

/// How the layered depth image of a portal is made.
enum class LdiMaking {
  kWarp,     ///< captures, warped into the central view (Rafferty et al. 1998, Figure 4b)
  kRayCast,  ///< rays of the central view, each kept wherever a viewpoint sees it (Figure 4a)
};

/// How the images of a portal are captured.  Lengths in metres.
struct ImageParameters {
  static constexpr double kDoorHeight = 2.1;   ///< [m] of the portal that `image_size` is meant for
  static constexpr double kMostPixels = 4096;  ///< across or down a capture

  /// Which kinds are baked.  Textures and reference images take more of the disk than the LDIs.
  ImageKinds bake = {false, false, true};
  int image_size = 384;  ///< [pixels] [16…4096] rows of a capture of a portal 2.1 m high; others in
                         ///< proportion, since all switch to geometry at one distance
  std::vector<CaptureRing> rings = {  // the first is the main one
      {13, 75.0f, 0.0f},              ///< the paper's one ring
      {9, 70.0f, -0.5f},              ///< what hides under tables: the eye looks down at it
      {5, 60.0f, 0.3f}};              ///< what hides above sills and shelves, and the sky
  LdiMaking ldi = LdiMaking::kWarp;
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
