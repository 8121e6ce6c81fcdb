#include "render/texture_sampler.h"

#include <algorithm>
#include <cmath>

#include "render/mip_chain.h"
#include "render/texel_words.h"

namespace enfilade {
namespace {

/// The texel that coordinate `i` of an axis with `size` texels stands for.
int wrapped(int i, int size, Wrap wrap) noexcept {
  if (i >= 0 && i < size) return i;
  if (wrap == Wrap::kClampToEdge) return i < 0 ? 0 : size - 1;
  const int period = wrap == Wrap::kRepeat ? size : 2 * size;
  const int rest = i % period;
  const int positive = rest < 0 ? rest + period : rest;
  return positive < size ? positive : period - 1 - positive;
}

glm::vec4 channels(std::uint64_t wide, float scale) noexcept {
  return scale * glm::vec4(static_cast<float>(wide & 0xffff),
                           static_cast<float>(wide >> 16 & 0xffff),
                           static_cast<float>(wide >> 32 & 0xffff), static_cast<float>(wide >> 48));
}

/// floor() as an integer, kept where an int can hold it.
int floorToInt(float v) noexcept {
  const float limited = v > -1.0e9f ? std::min(v, 1.0e9f) : -1.0e9f;  // also not a number
  const int i = static_cast<int>(limited);
  return static_cast<float>(i) > limited ? i - 1 : i;
}

glm::vec4 nearest(const Image& image, const Material& material, const glm::vec2& uv) noexcept {
  const int x =
      wrapped(floorToInt(uv.x * static_cast<float>(image.width)), image.width, material.wrap_s);
  const int y =
      wrapped(floorToInt(uv.y * static_cast<float>(image.height)), image.height, material.wrap_t);
  return channels(
      texelWord(
          &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x))]),
      1.0f);
}

/// Between two texels in 1/256, rounded; `part` 0…256.
std::uint64_t between(std::uint64_t a, std::uint64_t b, std::uint64_t part) noexcept {
  return ((256 - part) * a + part * b + 0x0080008000800080ULL) >> 8 & 0x00ff00ff00ff00ffULL;
}

/// How far `v` lies beyond `floor` in 1/256, 0…256; 0 if it is not a number.
std::uint64_t partBeyond(float v, int floor) noexcept {
  const float share = v - static_cast<float>(floor);
  return share > 0 ? static_cast<std::uint64_t>(std::min(share, 1.0f) * 256.0f + 0.5f) : 0;
}

/// All four channels are worked out in one multiplication, with weights of 1/256.
glm::vec4 linear(const Image& image, const Material& material, const glm::vec2& uv) noexcept {
  const float x = uv.x * static_cast<float>(image.width) - 0.5f;
  const float y = uv.y * static_cast<float>(image.height) - 0.5f;
  const int left = floorToInt(x);
  const int top = floorToInt(y);
  const std::uint64_t across = partBeyond(x, left);
  const std::uint64_t down = partBeyond(y, top);
  const std::size_t width = static_cast<std::size_t>(image.width);
  const auto x0 = static_cast<std::size_t>(wrapped(left, image.width, material.wrap_s));
  const auto x1 = static_cast<std::size_t>(wrapped(left + 1, image.width, material.wrap_s));
  const auto row0 = width * static_cast<std::size_t>(wrapped(top, image.height, material.wrap_t));
  const auto row1 =
      width * static_cast<std::size_t>(wrapped(top + 1, image.height, material.wrap_t));
  const std::uint8_t* texels = image.rgba.data();
  const std::uint64_t upper =
      between(texelWord(texels + 4 * (row0 + x0)), texelWord(texels + 4 * (row0 + x1)), across);
  const std::uint64_t lower =
      between(texelWord(texels + 4 * (row1 + x0)), texelWord(texels + 4 * (row1 + x1)), across);
  return channels((256 - down) * upper + down * lower, 1.0f / 256.0f);
}

/// Near 0, so that no texel's place needs a division.
float reduced(float v, Wrap wrap) noexcept {
  return wrap == Wrap::kRepeat ? v - static_cast<float>(floorToInt(v)) : v;
}

}  // namespace

TextureSampler::TextureSampler(const Image& image)
    : size_(image.width, image.height), image_(image), smaller_(mipChain(image)) {}

glm::vec4 TextureSampler::sample(const Material& material, const glm::vec2& texcoord,
                                 float level_of_detail) const noexcept {
  const glm::vec2 uv(reduced(texcoord.x, material.wrap_s), reduced(texcoord.y, material.wrap_t));
  if (!(level_of_detail > 0.0f)) {
    return material.nearest_filter ? nearest(image_, material, uv) : linear(image_, material, uv);
  }
  const auto last = static_cast<float>(smaller_.size());
  const float level = std::min(level_of_detail, last);
  const auto finer = static_cast<std::size_t>(level);
  const float part = level - static_cast<float>(finer);
  const glm::vec4 a = linear(finer == 0 ? image_ : smaller_[finer - 1], material, uv);
  if (finer == smaller_.size()) return a;
  return glm::mix(a, linear(smaller_[finer], material, uv), part);
}

}  // namespace enfilade
