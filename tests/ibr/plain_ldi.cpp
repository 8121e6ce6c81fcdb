#include "plain_ldi.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ibr/warp_transform.h"

namespace enfilade::testing {
namespace {

struct Layer {
  glm::vec2 at;  // pixels of the central image
  float disparity;
  float area;
  glm::vec2 size;
  CaptureSample sample;
  std::size_t capture;
};

/// By row, then by column.
using Pixels = std::map<std::pair<int, int>, std::vector<Layer>>;

Layer warped(const CaptureSamples& capture, const CaptureSample& s, const PlanarCamera& central) {
  const WarpTransform warp = warpTransform(capture.camera, central);
  const auto disparity = static_cast<double>(s.disparity);
  const glm::dvec3 h =
      warp.homogeneous(static_cast<double>(s.u), static_cast<double>(s.v), disparity);
  const glm::dvec2 at = glm::dvec2(h) / h.z;
  // How far the sample moves for a pixel of its capture, along its surface.
  const auto side = [&](int axis, float slope) {
    const glm::dvec3 step =
        warp.to_from_pixel[axis] + static_cast<double>(slope) * warp.per_disparity;
    return glm::abs((glm::dvec2(step) - at * step.z) / h.z);
  };
  Layer layer;
  layer.at = glm::vec2(at);
  layer.disparity = static_cast<float>(disparity / h.z);
  layer.area = s.doubt * static_cast<float>(patchArea(capture.camera, s));
  layer.size = glm::vec2(static_cast<double>(s.width) * side(0, s.slope_u) +
                         static_cast<double>(s.height) * side(1, s.slope_v));
  layer.sample = s;
  return layer;
}

bool isWithin(const glm::vec2& at, const PlanarCamera& central, float half_width) {
  const auto tile = [](float pixel) { return std::floor(pixel / kLdiTile); };
  const auto within = [&](float pixel, int pixels) {
    const float half = 0.5f * static_cast<float>(pixels);
    return tile(pixel) >= tile(half - half_width * half) &&
           tile(pixel) <= tile(half + half_width * half);
  };
  return within(at.x, central.width) && within(at.y, central.height);
}

void insert(std::vector<Layer>& layers, Layer layer, float threshold) {
  const auto cover = [](Layer& stays, const Layer& goes) {
    stays.size = glm::max(stays.size, glm::min(goes.size, LdiBuilder::kLeastCover));
  };
  const auto meets = [&](const Layer& there) {
    return there.capture != layer.capture &&
           std::abs(there.disparity - layer.disparity) <= threshold;
  };
  const auto yieldsTo = [&](const Layer& there) {
    const bool central = there.capture == 0 && layer.capture != 0;
    return (central && layer.disparity > there.disparity) ||
           (meets(there) && (central || there.area <= layer.area));
  };
  const auto stronger = std::find_if(layers.begin(), layers.end(), yieldsTo);
  if (stronger != layers.end()) {
    if (meets(*stronger)) cover(*stronger, layer);
    return;
  }
  for (const Layer& there : layers) {
    if (meets(there)) cover(layer, there);
  }
  std::erase_if(layers, meets);
  layers.push_back(layer);
  std::stable_sort(layers.begin(), layers.end(),
                   [](const Layer& a, const Layer& b) { return a.disparity > b.disparity; });
}

/// The samples of `pixels` as an LDI without its window.
Ldi stored(const Pixels& pixels) {
  std::map<std::pair<int, int>, std::vector<LdiSample>> tiles;
  for (const auto& [row_column, layers] : pixels) {
    for (const Layer& l : layers) {
      const glm::vec2 tile = glm::floor(l.at / float{kLdiTile});
      const glm::vec2 in_tile = l.at - tile * float{kLdiTile};
      tiles[{static_cast<int>(tile.y), static_cast<int>(tile.x)}].push_back(
          {l.sample.r, l.sample.g, l.sample.b, packFootprint(l.size.x, l.size.y),
           packPlace(in_tile.x, in_tile.y, l.disparity)});
    }
  }
  Ldi ldi;
  for (auto& [row_column, samples] : tiles) {
    std::stable_sort(samples.begin(), samples.end(),
                     [](const LdiSample& a, const LdiSample& b) { return a.place < b.place; });
    LdiTile tile;
    tile.count = static_cast<std::uint32_t>(samples.size());
    ldi.tiles.push_back(tile);
    ldi.samples.insert(ldi.samples.end(), samples.begin(), samples.end());
  }
  return ldi;
}

}  // namespace

Ldi plainLdi(const PlanarCamera& central, const LdiRules& rules,
             const std::vector<CaptureSamples>& captures) {
  const float threshold = disparityThreshold(central, rules.depth_threshold);
  Pixels pixels;
  for (std::size_t i = 0; i < captures.size(); ++i) {
    for (const CaptureSample& s : captures[i].samples) {
      Layer layer = warped(captures[i], s, central);
      layer.capture = i;
      if (!(layer.disparity > 0) || !isWithin(layer.at, central, rules.half_width)) continue;
      const glm::ivec2 pixel(glm::floor(layer.at));
      insert(pixels[{pixel.y, pixel.x}], layer, threshold);
    }
  }
  return stored(pixels);
}

}  // namespace enfilade::testing
