#include "app/image_quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace enfilade {

namespace {

std::size_t pixelCount(const Image& image) { return image.rgba.size() / 4; }

bool sameSize(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size();
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
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int difference = a.rgba[i + c] - b.rgba[i + c];
      squares += static_cast<std::uint64_t>(difference * difference);
    }
  }
  return psnrOfSquares(squares, pixelCount(a));
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

ImageQuality compareImages(const Image& picture, const Image& truth) {
  assert(sameSize(picture, truth));
  if (picture.rgba == truth.rgba) return {};
  return {psnr(picture, truth), ssim(picture, truth), differingPercent(picture, truth)};
}

}  // namespace enfilade
