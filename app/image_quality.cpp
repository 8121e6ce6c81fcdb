#include "app/image_quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace enfilade {

namespace {

std::size_t pixelCount(const Image& image) { return image.rgba.size() / 4; }

[[maybe_unused]] bool sameSize(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size();
}

std::uint64_t squaresOfPixel(const Image& a, const Image& b, std::size_t pixel) {
  std::uint64_t squares = 0;
  for (std::size_t i = 4 * pixel; i < 4 * pixel + 3; ++i) {
    const int difference = a.rgba[i] - b.rgba[i];
    squares += static_cast<std::uint64_t>(difference * difference);
  }
  return squares;
}

double psnrOfSquares(std::uint64_t squares, std::size_t pixels) {
  if (squares == 0) return kIdenticalPsnr;
  const double mean = static_cast<double>(squares) / (3.0 * static_cast<double>(pixels));
  return std::min(kIdenticalPsnr, 10.0 * std::log10(255.0 * 255.0 / mean));
}

}  // namespace

double psnr(const Image& a, const Image& b) {
  assert(sameSize(a, b));
  std::uint64_t squares = 0;
  for (std::size_t i = 0; i < pixelCount(a); ++i) squares += squaresOfPixel(a, b, i);
  return psnrOfSquares(squares, pixelCount(a));
}

std::optional<double> psnr(const Image& a, const Image& b, MaskView mask) {
  assert(sameSize(a, b) && mask.size() == pixelCount(a));
  std::uint64_t squares = 0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    squares += squaresOfPixel(a, b, i);
    ++pixels;
  }
  if (pixels == 0) return std::nullopt;
  return psnrOfSquares(squares, pixels);
}

std::optional<double> meanDifference(const Image& a, const Image& b, MaskView mask) {
  assert(sameSize(a, b) && mask.size() == pixelCount(a));
  std::uint64_t sum = 0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    for (std::size_t k = 4 * i; k < 4 * i + 3; ++k) {
      sum += static_cast<std::uint64_t>(std::abs(a.rgba[k] - b.rgba[k]));
    }
    ++pixels;
  }
  if (pixels == 0) return std::nullopt;
  return static_cast<double>(sum) / (3.0 * static_cast<double>(pixels));
}

double differingPercent(const Image& a, const Image& b) {
  assert(sameSize(a, b));
  if (a.rgba.empty()) return 0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    differing += !std::equal(&a.rgba[i], &a.rgba[i] + 3, &b.rgba[i]);
  }
  return 100.0 * static_cast<double>(differing) / static_cast<double>(pixelCount(a));
}

ImageQuality compareImages(const Image& picture, const Image& truth, MaskView portals) {
  assert(sameSize(picture, truth));
  ImageQuality quality;
  if (!portals.empty()) quality.psnr_portals_db = psnr(picture, truth, portals);
  if (picture.rgba == truth.rgba && !quality.psnr_portals_db) return quality;
  const Similarity similarity = similarityOf(picture, truth, portals);
  quality.psnr_db = psnr(picture, truth);
  quality.ssim = similarity.mean;
  quality.ssim_portals = similarity.mean_over_mask;
  quality.differing_percent = differingPercent(picture, truth);
  return quality;
}

}  // namespace enfilade
