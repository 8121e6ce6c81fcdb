#include "app/image_quality.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

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

/// The definition, window by window: weighted means, then central moments about them.  The mean
/// over the windows whose middle `counts(x, y)`.
template <typename Counts>
double bruteForceSsim(const Image& a, const Image& b, const Counts& counts) {
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
    for (int x = 5; x + 5 < a.width; ++x) {
      if (!counts(x, y)) continue;
      ++windows;
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
    const auto all = [](int, int) { return true; };
    EXPECT_NEAR(ssim(picture, truth), bruteForceSsim(picture, truth, all), 1e-9) << amount;
  }
}

/// Of a few pixels here and there, with a byte of its own each.
std::vector<std::uint8_t> scatteredMask(int width, int height) {
  std::vector<std::uint8_t> mask;
  for (int i = 0; i < width * height; ++i) {
    mask.push_back(static_cast<std::uint8_t>(i % 7 < 2 ? i % 250 + 1 : 0));
  }
  return mask;
}

TEST(ImageQuality, SsimOverAMaskIsTheMeanOfTheWindowsAroundItsPixels) {
  const Image truth = noise(37, 23, 5);
  const std::vector<std::uint8_t> mask = scatteredMask(37, 23);
  const Image picture = disturbed(truth, 60, 6);
  const auto masked = [&](int x, int y) { return mask[static_cast<std::size_t>(y * 37 + x)] != 0; };
  const Similarity similarity = similarityOf(picture, truth, mask);
  EXPECT_EQ(similarity.mean, ssim(picture, truth));
  EXPECT_NEAR(similarity.mean_over_mask.value(), bruteForceSsim(picture, truth, masked), 1e-9);
}

TEST(ImageQuality, SsimOfPicturesThatDifferInOnePlaceIsTheDefinitionToo) {
  const Image truth = noise(60, 50, 5);
  const std::vector<std::uint8_t> mask = scatteredMask(60, 50);
  const auto all = [](int, int) { return true; };
  const auto masked = [&](int x, int y) { return mask[static_cast<std::size_t>(y * 60 + x)] != 0; };
  for (const int at : {0, 25 * 60 + 30, 20 * 60 + 59, 49 * 60 + 59}) {
    Image picture = truth;
    for (std::size_t c = 0; c < 3; ++c) picture.rgba[4 * static_cast<std::size_t>(at) + c] ^= 128;
    const Similarity similarity = similarityOf(picture, truth, mask);
    EXPECT_NEAR(similarity.mean, bruteForceSsim(picture, truth, all), 1e-9) << at;
    EXPECT_NEAR(*similarity.mean_over_mask, bruteForceSsim(picture, truth, masked), 1e-9) << at;
    EXPECT_LT(similarity.mean, 1) << at;
  }
}

TEST(ImageQuality, SsimIsTheSameForAnyNumberOfThreads) {
  const Image truth = noise(200, 180, 5);
  const Image picture = disturbed(truth, 40, 6);
  const std::vector<std::uint8_t> mask = scatteredMask(200, 180);
  const Similarity many = similarityOf(picture, truth, mask);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Similarity alone = similarityOf(picture, truth, mask);
  EXPECT_EQ(many.mean, alone.mean);
  EXPECT_EQ(many.mean_over_mask, alone.mean_over_mask);
}

TEST(ImageQuality, AMaskAtTheBorderHasNoWindows) {
  const Image truth = noise(40, 30, 5);
  std::vector<std::uint8_t> mask(40 * 30, 0);
  EXPECT_FALSE(similarityOf(truth, disturbed(truth, 9, 6), mask).mean_over_mask);
  EXPECT_FALSE(psnr(truth, truth, mask));
  EXPECT_FALSE(meanDifference(truth, truth, mask));
  mask[3] = mask[20 * 40 + 4] = mask[25 * 40 + 20] = 1;
  EXPECT_FALSE(similarityOf(truth, disturbed(truth, 9, 6), mask).mean_over_mask);
  EXPECT_EQ(psnr(truth, truth, mask), kIdenticalPsnr);
}

TEST(ImageQuality, OverAMaskOnlyItsPixelsCount) {
  Image other = uniform(20, 20, 100);
  for (std::size_t i = 100; i < 300; ++i) {
    for (std::size_t c = 0; c < 3; ++c) other.rgba[4 * i + c] = i < 200 ? 105 : 255;
  }
  std::vector<std::uint8_t> mask(400, 0);
  std::fill_n(mask.begin() + 100, 100, std::uint8_t{1});
  const Image truth = uniform(20, 20, 100);
  EXPECT_NEAR(psnr(other, truth, mask).value(), 34.1514, 1e-4);  // all off by 5
  EXPECT_DOUBLE_EQ(meanDifference(other, truth, mask).value(), 5);
  const ImageQuality quality = compareImages(other, truth, mask);
  EXPECT_EQ(quality.psnr_portals_db, psnr(other, truth, mask));
  EXPECT_EQ(quality.psnr_db, psnr(other, truth));
  EXPECT_TRUE(quality.ssim_portals);
  EXPECT_FALSE(compareImages(other, truth).psnr_portals_db);
  EXPECT_FALSE(compareImages(other, truth).ssim_portals);
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
