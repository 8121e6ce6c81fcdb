#include "render/mip_chain.h"

#include <algorithm>
#include <glm/glm.hpp>

namespace enfilade {
namespace {

/// The source texels along one axis that texel `i` of the smaller level covers, and how much of
/// each: two, or three where the size is odd.
struct Taps {
  int first = 0;
  int count = 0;
  float weights[3] = {};
};

Taps tapsOf(int i, int size, int smaller) {
  const float scale = static_cast<float>(size) / static_cast<float>(smaller);
  const float begin = static_cast<float>(i) * scale;
  const float end = begin + scale;
  Taps taps;
  taps.first = static_cast<int>(begin);
  for (int k = 0; k < 3 && taps.first + k < size; ++k) {
    const float low = std::max(begin, static_cast<float>(taps.first + k));
    const float high = std::min(end, static_cast<float>(taps.first + k + 1));
    if (high - low < 1e-4f) break;
    taps.weights[taps.count++] = (high - low) / scale;
  }
  return taps;
}

glm::vec4 texel(const Image& image, int x, int y) {
  const std::uint8_t* p =
      &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x))];
  return {p[0], p[1], p[2], p[3]};
}

glm::vec4 mean(const Image& image, const Taps& across, const Taps& down) {
  glm::vec4 plain(0);
  glm::vec3 by_alpha(0);
  for (int j = 0; j < down.count; ++j) {
    for (int i = 0; i < across.count; ++i) {
      const glm::vec4 t = texel(image, across.first + i, down.first + j);
      const float weight = across.weights[i] * down.weights[j];
      plain += weight * t;
      by_alpha += weight * t.a * glm::vec3(t);
    }
  }
  // What is invisible must not bleed into what is not.
  return plain.a > 0.0f ? glm::vec4(by_alpha / plain.a, plain.a) : plain;
}

Image halved(const Image& image) {
  Image smaller;
  smaller.width = std::max(1, image.width / 2);
  smaller.height = std::max(1, image.height / 2);
  smaller.rgba.reserve(4 * static_cast<std::size_t>(smaller.width) *
                       static_cast<std::size_t>(smaller.height));
  for (int y = 0; y < smaller.height; ++y) {
    const Taps down = tapsOf(y, image.height, smaller.height);
    for (int x = 0; x < smaller.width; ++x) {
      const glm::vec4 t = mean(image, tapsOf(x, image.width, smaller.width), down);
      for (int c = 0; c < 4; ++c) {
        smaller.rgba.push_back(static_cast<std::uint8_t>(std::clamp(t[c] + 0.5f, 0.0f, 255.0f)));
      }
    }
  }
  return smaller;
}

}  // namespace

std::vector<Image> mipChain(const Image& image) {
  std::vector<Image> levels;
  const Image* last = &image;
  while (last->width > 1 || last->height > 1) {
    levels.push_back(halved(*last));
    last = &levels.back();
  }
  return levels;
}

}  // namespace enfilade
