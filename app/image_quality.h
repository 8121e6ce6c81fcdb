#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "scene/image.h"

namespace enfilade {

inline constexpr double kIdenticalPsnr = 100.0;  ///< [dB] the cap, which means identical

/// How far a picture is from the true one.  Alpha is not looked at.
struct ImageQuality {
  double psnr_db = kIdenticalPsnr;
  double ssim = 1;
  double differing_percent = 0;
  /// The same over the pixels of portals' images alone; empty where there are none.
  std::optional<double> psnr_portals_db = {};
  std::optional<double> ssim_portals = {};
};

/// A mask has a byte a pixel, row 0 on top: not 0 where the pixel counts.
using MaskView = std::span<const std::uint8_t>;

/// Peak signal-to-noise ratio [dB] over red, green and blue alike, peak 255; at most 100.
double psnr(const Image& a, const Image& b);

/// The same over the pixels of `mask`; empty if there are none.
std::optional<double> psnr(const Image& a, const Image& b, MaskView mask);

/// Mean absolute difference [8-bit levels] of red, green and blue over the pixels of `mask`; empty
/// if there are none.
std::optional<double> meanDifference(const Image& a, const Image& b, MaskView mask);

/// Mean structural similarity of the luma (BT.601): Gaussian windows of 11 × 11, sigma 1.5, that
/// lie wholly inside the picture; K1 = 0.01, K2 = 0.03, L = 255.  Both at least 11 × 11 pixels;
/// smaller pictures are compared as one window without weights.
/// Source: Wang, Bovik, Sheikh & Simoncelli, Image Quality Assessment, 2004.
double ssim(const Image& a, const Image& b);

struct Similarity {
  double mean = 1;                       ///< as of ssim()
  std::optional<double> mean_over_mask;  ///< over the windows around the mask's pixels
};

/// The mean over the windows around the pixels of `mask` (or an empty one) as well: it is empty if
/// none of those pixels is the middle of a window.  The same values for any number of threads.
Similarity similarityOf(const Image& a, const Image& b, MaskView mask);

/// The share of pixels [percent] whose red, green or blue differ at all.
double differingPercent(const Image& a, const Image& b);

/// All of them.  The pictures have the same size; `portals` is the mask of the pixels of portals'
/// images, or empty.
ImageQuality compareImages(const Image& picture, const Image& truth, MaskView portals = {});

}  // namespace enfilade
