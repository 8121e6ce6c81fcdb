#pragma once

#include "scene/image.h"

namespace enfilade {

inline constexpr double kIdenticalPsnr = 100.0;  ///< [dB] the cap, which means identical

/// How far a picture is from the true one.  Alpha is not looked at.
struct ImageQuality {
  double psnr_db = kIdenticalPsnr;
  double ssim = 1;
  double differing_percent = 0;
};

/// Peak signal-to-noise ratio [dB] over red, green and blue alike, peak 255; at most 100.
double psnr(const Image& a, const Image& b);

/// Mean structural similarity of the luma (BT.601): Gaussian windows of 11 × 11, sigma 1.5, that
/// lie wholly inside the picture; K1 = 0.01, K2 = 0.03, L = 255.  Both at least 11 × 11 pixels;
/// smaller pictures are compared as one window without weights.
/// Source: Wang, Bovik, Sheikh & Simoncelli, Image Quality Assessment, 2004.
double ssim(const Image& a, const Image& b);

/// The share of pixels [percent] whose red, green or blue differ at all.
double differingPercent(const Image& a, const Image& b);

/// All three.  The pictures have the same size.
ImageQuality compareImages(const Image& picture, const Image& truth);

}  // namespace enfilade
