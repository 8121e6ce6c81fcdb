#include "app/view/layer_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade {

namespace {

constexpr std::array<std::array<float, 3>, 4> kLayers = {
    {{0.35f, 0.85f, 0.35f}, {0.95f, 0.90f, 0.25f}, {1.0f, 0.60f, 0.15f}, {0.95f, 0.25f, 0.20f}}};

void color(LdiSample& sample, std::size_t layer) {
  const auto& layer_color = kLayers[std::min(layer, kLayers.size() - 1)];
  const float bright =
      0.35f + 0.65f * (0.30f * sample.r + 0.59f * sample.g + 0.11f * sample.b) / 255.0f;
  const auto channel = [&](std::size_t c) {
    return static_cast<std::uint8_t>(std::lround(255.0f * bright * layer_color[c]));
  };
  sample.r = channel(0);
  sample.g = channel(1);
  sample.b = channel(2);
}

}  // namespace

Ldi coloredByLayer(const Ldi& ldi) {
  Ldi colored = ldi;
  for (const LdiTile& tile : colored.tiles) {
    std::array<std::size_t, kLdiTile * kLdiTile> nearer{};  // samples of each pixel so far
    for (std::size_t i = tile.first + tile.count; i-- > tile.first;) {  // nearest first
      LdiSample& sample = colored.samples[i];
      const auto x = static_cast<std::size_t>(xInTile(sample));
      const auto y = static_cast<std::size_t>(yInTile(sample));
      color(sample, nearer[y * kLdiTile + x]++);
    }
  }
  return colored;
}

const Ldi* LayerColors::of(const Ldi& ldi) {
  Entry& entry = made_[&ldi];
  if (entry.samples != ldi.samples.size()) {
    entry = {ldi.samples.size(), coloredByLayer(ldi)};
  }
  return &entry.colored;
}

}  // namespace enfilade
