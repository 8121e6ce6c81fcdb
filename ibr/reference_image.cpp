// Rafferty et al., Images for Accelerating Architectural Walkthroughs, 1998, sec. 3.1.
#include "ibr/reference_image.h"

#include <algorithm>

namespace enfilade {
namespace {

/// Appends the samples of the tile whose corner is pixel (x0, y0).
void appendTile(const DepthImage& image, int x0, int y0, std::vector<LdiSample>& samples) {
  const auto first = static_cast<std::ptrdiff_t>(samples.size());
  const std::uint8_t footprint = packFootprint(1.0f, 1.0f);
  for (int y = y0; y < std::min(y0 + kLdiTile, image.camera.height); ++y) {
    for (int x = x0; x < std::min(x0 + kLdiTile, image.camera.width); ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(image.camera.width) +
          static_cast<std::size_t>(x);
      if (image.disparity[pixel] <= 0.0f) continue;
      const std::uint8_t* rgba = &image.color.rgba[4 * pixel];
      samples.push_back({rgba[0], rgba[1], rgba[2], footprint,
                         packPlace(static_cast<float>(x - x0) + 0.5f,
                                   static_cast<float>(y - y0) + 0.5f, image.disparity[pixel])});
    }
  }
  std::sort(samples.begin() + first, samples.end(),
            [](const LdiSample& a, const LdiSample& b) { return a.place < b.place; });
}

}  // namespace

Ldi referenceImage(const DepthImage& image) {
  Ldi ldi;
  ldi.camera = image.camera;
  for (int y = 0; y < image.camera.height; y += kLdiTile) {
    for (int x = 0; x < image.camera.width; x += kLdiTile) {
      const std::size_t before = ldi.samples.size();
      appendTile(image, x, y, ldi.samples);
      if (ldi.samples.size() == before) continue;
      LdiTile tile;
      tile.x = static_cast<std::uint16_t>(x / kLdiTile);
      tile.y = static_cast<std::uint16_t>(y / kLdiTile);
      tile.count = static_cast<std::uint32_t>(ldi.samples.size() - before);
      ldi.tiles.push_back(tile);
    }
  }
  indexTiles(ldi);
  return ldi;
}

Ldi captureReference(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                     const ImageParameters& parameters, const CaptureFunction& capture) {
  DepthImage image = capture(portalCamera(portal, from_front, viewpoint, parameters));
  maskBeyondMargin(image, portal, parameters.portal_margin);
  return referenceImage(image);
}

}  // namespace enfilade
