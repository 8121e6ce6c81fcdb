#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/mip_chain.h"
#include "render/texture_sampler.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

Image noise(int width, int height, bool opaque) {
  std::mt19937 random(5);
  Image image;
  image.width = width;
  image.height = height;
  for (int i = 0; i < 4 * width * height; ++i) {
    image.rgba.push_back(opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(random() & 255));
  }
  return image;
}

TEST(MipChain, HalvesDownToOneTexelRoundingSizesDown) {
  const std::vector<Image> levels = mipChain(noise(37, 6, true));
  const std::vector<glm::ivec2> sizes = {{18, 3}, {9, 1}, {4, 1}, {2, 1}, {1, 1}};
  ASSERT_EQ(levels.size(), sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    EXPECT_EQ(glm::ivec2(levels[i].width, levels[i].height), sizes[i]);
    EXPECT_EQ(levels[i].rgba.size(), static_cast<std::size_t>(4 * sizes[i].x * sizes[i].y));
  }
  EXPECT_TRUE(mipChain(noise(1, 1, true)).empty());
}

TEST(MipChain, KeepsTheMeanOfTheWholePicture) {
  for (const glm::ivec2 size : {glm::ivec2(64, 64), glm::ivec2(37, 6), glm::ivec2(5, 5)}) {
    const Image image = noise(size.x, size.y, true);
    double mean = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) mean += image.rgba[i];
    mean /= size.x * size.y;
    EXPECT_NEAR(mipChain(image).back().rgba[0], mean, 2.5);
  }
}

TEST(MipChain, InvisibleTexelsDoNotBleed) {
  const Image image = checkers(4, 1, {200, 100, 50, 255}, {0, 255, 0, 0});
  EXPECT_EQ(pixelAt(mipChain(image)[0], 1, 1), glm::ivec4(200, 100, 50, 128));
}

/// The same in double precision, texel by texel.
glm::dvec4 slowLinear(const Image& image, Wrap wrap, glm::dvec2 uv) {
  const auto place = [&](double i, int size) {
    double rest = i;
    if (wrap == Wrap::kClampToEdge) rest = std::min(std::max(i, 0.0), size - 1.0);
    if (wrap == Wrap::kRepeat) rest = i - size * std::floor(i / size);
    if (wrap == Wrap::kMirroredRepeat) {
      rest = i - 2 * size * std::floor(i / (2 * size));
      rest = std::min(rest, 2 * size - 1 - rest);
    }
    return static_cast<int>(rest);
  };
  const double x = uv.x * image.width - 0.5;
  const double y = uv.y * image.height - 0.5;
  glm::dvec4 sum(0);
  for (int k = 0; k < 4; ++k) {
    const double i = std::floor(x) + k % 2;
    const double j = std::floor(y) + k / 2;
    const double weight = (1 - std::abs(x - i)) * (1 - std::abs(y - j));
    sum += weight * glm::dvec4(pixelAt(image, place(i, image.width), place(j, image.height)));
  }
  return sum;
}

TEST(TextureSampler, LinearFilterIsThatOfDoublePrecision) {
  const Image image = noise(13, 8, false);
  const TextureSampler sampler(image);
  std::mt19937 random(9);
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClampToEdge, Wrap::kMirroredRepeat}) {
    Material material;
    material.wrap_s = material.wrap_t = wrap;
    for (int i = 0; i < 2000; ++i) {
      const glm::vec2 uv(static_cast<float>(random() & 0xffff) / 8192.0f - 4.0f,
                         static_cast<float>(random() & 0xffff) / 8192.0f - 4.0f);
      const glm::dvec4 expected = slowLinear(image, wrap, uv);
      const glm::dvec4 actual = sampler.sample(material, uv, -1);
      EXPECT_LE(glm::length(actual - expected), 2.5) << uv.x << ", " << uv.y;
    }
  }
}

TEST(TextureSampler, GoesFromLevelToLevelWithoutAStep) {
  const Image image = checkers(16, 1, {0, 0, 0, 255}, {255, 255, 255, 255});
  const TextureSampler sampler(image);
  const Material material;
  const glm::vec2 uv(3.5f / 16, 3.5f / 16);
  EXPECT_EQ(sampler.sample(material, uv, 0).r, 0.0f);
  float last = 0;
  for (float level = 0; level < 6; level += 0.05f) {
    const float value = sampler.sample(material, uv, level).r;
    EXPECT_NEAR(value, last, 10);
    last = value;
  }
  EXPECT_NEAR(last, 127.5, 1);
}

TEST(TextureSampler, CoordinatesThatAreNoNumbersAreNoCrash) {
  const Image image = noise(3, 3, true);
  const TextureSampler sampler(image);
  Material material;
  const float nan = std::nanf("");
  for (const float bad : {nan, 1e30f, -1e30f, INFINITY}) {
    for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClampToEdge, Wrap::kMirroredRepeat}) {
      for (const bool nearest : {false, true}) {
        material.wrap_s = material.wrap_t = wrap;
        material.nearest_filter = nearest;
        const glm::vec4 value = sampler.sample(material, {bad, 0.5f}, nan);
        EXPECT_GE(value.r, 0);
        EXPECT_LE(value.r, 255);
        sampler.sample(material, {0.5f, bad}, INFINITY);
      }
    }
  }
}

}  // namespace
}  // namespace enfilade
