#include "app/image_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace enfilade {
namespace {

Image uniform(int width, int height, std::uint8_t value) {
  Image image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(4 * width * height), value);
  return image;
}

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image = uniform(width, height, 0);
  for (std::uint8_t& byte : image.rgba) byte = static_cast<std::uint8_t>(random() % 256);
  return image;
}

/// `image` with each byte moved by up to `amount`.
Image disturbed(Image image, int amount, unsigned seed) {
  std::mt19937 random(seed);
  for (std::uint8_t& byte : image.rgba) {
    const int by = static_cast<int>(random() % static_cast<unsigned>(2 * amount + 1)) - amount;
    byte = static_cast<std::uint8_t>(std::clamp(byte + by, 0, 255));
  }
  return image;
}

double lumaAt(const Image& image, int x, int y) {
  const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
  return 0.299 * image.rgba[i] + 0.587 * image.rgba[i + 1] + 0.114 * image.rgba[i + 2];
}

/// The definition, window by window: weighted means, then central moments about them.
double bruteForceSsim(const Image& a, const Image& b) {
  const auto weight = [](int dx, int dy) {
    return std::exp(-(dx * dx + dy * dy) / (2 * 1.5 * 1.5));
  };
  double total_weight = 0;
  for (int dy = -5; dy <= 5; ++dy) {
    for (int dx = -5; dx <= 5; ++dx) total_weight += weight(dx, dy);
  }
  double sum = 0;
  int windows = 0;
  for (int y = 5; y + 5 < a.height; ++y) {
    for (int x = 5; x + 5 < a.width; ++x, ++windows) {
      double mean_a = 0, mean_b = 0, var_a = 0, var_b = 0, covariance = 0;
      for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
          const double w = weight(dx, dy) / total_weight;
          mean_a += w * lumaAt(a, x + dx, y + dy);
          mean_b += w * lumaAt(b, x + dx, y + dy);
        }
      }
      for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
          const double w = weight(dx, dy) / total_weight;
          const double da = lumaAt(a, x + dx, y + dy) - mean_a;
          const double db = lumaAt(b, x + dx, y + dy) - mean_b;
          var_a += w * da * da;
          var_b += w * db * db;
          covariance += w * da * db;
        }
      }
      const double c1 = 6.5025, c2 = 58.5225;
      sum += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
             ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
    }
  }
  return sum / windows;
}

TEST(ImageQuality, IdenticalPicturesReachTheCap) {
  const Image image = noise(40, 30, 1);
  const ImageQuality quality = compareImages(image, image);
  EXPECT_DOUBLE_EQ(quality.psnr_db, 100);
  EXPECT_DOUBLE_EQ(quality.ssim, 1);
  EXPECT_DOUBLE_EQ(quality.differing_percent, 0);
  EXPECT_NEAR(ssim(image, image), 1, 1e-12);
}

TEST(ImageQuality, PsnrOfAConstantDifferenceIsByHand) {
  // Every channel off by 5: 10 log10(255² / 25).
  EXPECT_NEAR(psnr(uniform(8, 8, 100), uniform(8, 8, 105)), 34.1514, 1e-4);
  EXPECT_NEAR(psnr(uniform(8, 8, 0), uniform(8, 8, 255)), 0, 1e-12);
}

TEST(ImageQuality, OneChannelOffByOneIsUnderTheCap) {
  Image one_off = uniform(100, 100, 50);
  one_off.rgba[0] = 51;
  // Mean square error 1 / 30000: 48.1308 + 44.7712 dB.
  EXPECT_NEAR(psnr(one_off, uniform(100, 100, 50)), 92.9020, 1e-3);
}

TEST(ImageQuality, AlphaIsNotLookedAt) {
  Image other = uniform(16, 16, 9);
  for (std::size_t i = 3; i < other.rgba.size(); i += 4) other.rgba[i] = 200;
  const ImageQuality quality = compareImages(other, uniform(16, 16, 9));
  EXPECT_DOUBLE_EQ(quality.psnr_db, 100);
  EXPECT_DOUBLE_EQ(quality.differing_percent, 0);
  EXPECT_NEAR(quality.ssim, 1, 1e-12);
}

TEST(ImageQuality, DifferingPercentCountsPixelsNotChannels) {
  Image other = uniform(10, 10, 9);
  other.rgba[0] = 10;
  other.rgba[1] = 12;
  other.rgba[4 * 57 + 2] = 0;
  EXPECT_DOUBLE_EQ(differingPercent(other, uniform(10, 10, 9)), 2);
}

TEST(ImageQuality, SsimOfTwoFlatPicturesIsByHand) {
  // No variance: (2·100·120 + C1) / (100² + 120² + C1), C1 = 6.5025.
  EXPECT_NEAR(ssim(uniform(20, 15, 100), uniform(20, 15, 120)), 24006.5025 / 24406.5025, 1e-12);
}

TEST(ImageQuality, SsimIsTheDefinitionWindowByWindow) {
  for (const int amount : {3, 40, 200}) {
    const Image truth = noise(37, 23, 5);
    const Image picture = disturbed(truth, amount, 6);
    EXPECT_NEAR(ssim(picture, truth), bruteForceSsim(picture, truth), 1e-9) << amount;
  }
}

TEST(ImageQuality, MoreNoiseIsWorseByEveryMeasure) {
  const Image truth = noise(64, 48, 7);
  ImageQuality before;
  for (const int amount : {2, 10, 50}) {
    const ImageQuality quality = compareImages(disturbed(truth, amount, 8), truth);
    EXPECT_LT(quality.psnr_db, before.psnr_db);
    EXPECT_LT(quality.ssim, before.ssim);
    EXPECT_GT(quality.differing_percent, before.differing_percent);
    before = quality;
  }
}

TEST(ImageQuality, PicturesSmallerThanAWindowAreOneWindow) {
  EXPECT_NEAR(ssim(uniform(4, 4, 100), uniform(4, 4, 120)), 24006.5025 / 24406.5025, 1e-12);
}

}  // namespace
}  // namespace enfilade
