#include "render/mip_chain.h"

#include <algorithm>
#include <glm/glm.hpp>

#include "render/texel_words.h"

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

/// The mean of 2 × 2 opaque texels from `upper` and `lower` on; false where they are not opaque.
bool storeOpaqueMean(const std::uint8_t* upper, const std::uint8_t* lower,
                     std::uint8_t* out) noexcept {
  if ((upper[3] & upper[7] & lower[3] & lower[7]) != 255) return false;
  const std::uint64_t sum =
      texelWord(upper) + texelWord(upper + 4) + texelWord(lower) + texelWord(lower + 4);
  storeTexelWord((sum + 0x0002000200020002ULL) >> 2 & 0x00ff00ff00ff00ffULL, out);
  return true;
}

Image halved(const Image& image) {
  Image smaller;
  smaller.width = std::max(1, image.width / 2);
  smaller.height = std::max(1, image.height / 2);
  smaller.rgba.resize(4 * static_cast<std::size_t>(smaller.width) *
                      static_cast<std::size_t>(smaller.height));
  const bool even = image.width % 2 == 0 && image.height % 2 == 0;
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  std::uint8_t* out = smaller.rgba.data();
  for (int y = 0; y < smaller.height; ++y) {
    const Taps down = tapsOf(y, image.height, smaller.height);
    const std::uint8_t* upper = &image.rgba[row * static_cast<std::size_t>(down.first)];
    for (int x = 0; x < smaller.width; ++x, out += 4) {
      const std::uint8_t* left = upper + 8 * static_cast<std::size_t>(x);
      if (even && storeOpaqueMean(left, left + row, out)) continue;
      const glm::vec4 t = mean(image, tapsOf(x, image.width, smaller.width), down);
      for (int c = 0; c < 4; ++c) {
        out[c] = static_cast<std::uint8_t>(std::clamp(t[c] + 0.5f, 0.0f, 255.0f));
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
