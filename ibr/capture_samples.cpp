#include "ibr/capture_samples.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace enfilade {
namespace {

/// The pixels of a block, at most 4 × 4, where something is known.
struct Block {
  struct Pixel {
    int x, y;
    float disparity;
  };
  std::array<Pixel, 16> pixels{};
  std::size_t count = 0;
};

std::size_t indexOf(const DepthImage& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.camera.width) +
         static_cast<std::size_t>(x);
}

Block blockOf(const DepthImage& fine, int column, int row, int rays) {
  Block block;
  for (int y = row * rays; y < (row + 1) * rays; ++y) {
    for (int x = column * rays; x < (column + 1) * rays; ++x) {
      const float disparity = fine.disparity[indexOf(fine, x, y)];
      if (disparity > 0.0f) {
        block.pixels[block.count++] = {x, y, disparity};
      }
    }
  }
  return block;
}

/// The mean of some pixels of one surface.
class SurfaceMean {
 public:
  void add(const DepthImage& fine, const Block::Pixel& p) {
    const std::uint8_t* rgba = &fine.color.rgba[4 * indexOf(fine, p.x, p.y)];
    for (std::size_t c = 0; c < 3; ++c) {
      color_[c] += rgba[c];
    }
    least_ = glm::min(least_, glm::ivec2(p.x, p.y));
    greatest_ = glm::max(greatest_, glm::ivec2(p.x, p.y));
    x_ += p.x;
    y_ += p.y;
    disparity_ += static_cast<double>(p.disparity);
    ++pixels_;
  }

  CaptureSample sample(int rays) const {
    const double share = 1.0 / pixels_;
    const glm::vec2 part = glm::vec2(greatest_ - least_ + 1) / static_cast<float>(rays);
    CaptureSample s;
    s.u = static_cast<float>((x_ * share + 0.5) / rays);
    s.v = static_cast<float>((y_ * share + 0.5) / rays);
    s.width = part.x;
    s.height = part.y;
    s.disparity = static_cast<float>(disparity_ * share);
    const auto mean = [&](std::size_t c) {
      return static_cast<std::uint8_t>((color_[c] + pixels_ / 2) / pixels_);
    };
    s.r = mean(0);
    s.g = mean(1);
    s.b = mean(2);
    return s;
  }

 private:
  std::array<int, 3> color_{};
  glm::ivec2 least_{1 << 30};
  glm::ivec2 greatest_{-1};
  int x_ = 0, y_ = 0, pixels_ = 0;
  double disparity_ = 0.0;
};

/// Takes the nearest surface out of a block that is not empty.
CaptureSample takeNearestSurface(const DepthImage& fine, Block& block, int rays, float threshold) {
  float nearest = 0.0f;
  for (std::size_t i = 0; i < block.count; ++i) {
    nearest = std::max(nearest, block.pixels[i].disparity);
  }
  SurfaceMean mean;
  std::size_t left = 0;
  for (std::size_t i = 0; i < block.count; ++i) {
    if (nearest - block.pixels[i].disparity <= threshold) {
      mean.add(fine, block.pixels[i]);
    } else {
      block.pixels[left++] = block.pixels[i];
    }
  }
  block.count = left;
  return mean.sample(rays);
}

/// Samples by block, with a border of empty blocks all around.
struct BlockGrid {
  std::size_t stride = 0;
  std::vector<CaptureSample> samples;
  std::vector<std::size_t> first;  ///< block i holds samples [first[i], first[i + 1])

  std::span<const CaptureSample> at(std::size_t block) const {
    return std::span(samples).subspan(first[block], first[block + 1] - first[block]);
  }
};

/// The gentlest of the slopes to the samples of two neighbouring blocks, or 0 if even that one is
/// too steep for a surface: across a silhouette they are.
float gentlestSlope(const CaptureSample& at, std::span<const CaptureSample> before,
                    std::span<const CaptureSample> after, float CaptureSample::*along) {
  constexpr float kLeastStep = 0.25f;  // [pixels] closer samples say little about the slope
  constexpr float kSteepest = 0.1f;    // [of the disparity, per pixel]
  float gentlest = kSteepest * at.disparity;
  bool known = false;
  for (const auto& neighbours : {before, after}) {
    for (const CaptureSample& other : neighbours) {
      const float step = other.*along - at.*along;
      if (std::abs(step) >= kLeastStep) {
        const float slope = (other.disparity - at.disparity) / step;
        if (std::abs(slope) < std::abs(gentlest)) {
          gentlest = slope;
          known = true;
        }
      }
    }
  }
  return known ? gentlest : 0.0f;
}

BlockGrid gridOf(const DepthImage& fine, int rays, float threshold) {
  const int width = fine.camera.width / rays;
  const int height = fine.camera.height / rays;
  BlockGrid grid;
  grid.stride = static_cast<std::size_t>(width) + 2;
  grid.first.reserve(grid.stride * (static_cast<std::size_t>(height) + 2) + 1);
  for (int row = -1; row <= height; ++row) {
    for (int column = -1; column <= width; ++column) {
      grid.first.push_back(grid.samples.size());
      if (row >= 0 && row < height && column >= 0 && column < width) {
        Block block = blockOf(fine, column, row, rays);
        while (block.count > 0) {
          grid.samples.push_back(takeNearestSurface(fine, block, rays, threshold));
        }
      }
    }
  }
  grid.first.push_back(grid.samples.size());
  return grid;
}

}  // namespace

CaptureSamples resolveCapture(const DepthImage& fine, int rays, float threshold) {
  assert(rays >= 1 && rays <= 4);
  assert(fine.camera.width % rays == 0 && fine.camera.height % rays == 0);
  const BlockGrid grid = gridOf(fine, rays, threshold);
  CaptureSamples capture;
  capture.camera = fine.camera;
  capture.camera.world_from_pixel[0] *= rays;
  capture.camera.world_from_pixel[1] *= rays;
  capture.camera.width = fine.camera.width / rays;
  capture.camera.height = fine.camera.height / rays;
  capture.samples = grid.samples;
  for (std::size_t i = grid.stride; i + grid.stride + 1 < grid.first.size(); ++i) {
    for (std::size_t k = grid.first[i]; k < grid.first[i + 1]; ++k) {
      CaptureSample& s = capture.samples[k];
      s.slope_u = gentlestSlope(s, grid.at(i - 1), grid.at(i + 1), &CaptureSample::u);
      s.slope_v =
          gentlestSlope(s, grid.at(i - grid.stride), grid.at(i + grid.stride), &CaptureSample::v);
    }
  }
  return capture;
}

double patchArea(const PlanarCamera& camera, const CaptureSample& s) noexcept {
  // X(u, v) = center + r/δ with r = P·(u, v, 1): the area of a pixel is |∂X/∂u × ∂X/∂v|.
  const glm::dmat3& p = camera.world_from_pixel;
  const auto d = static_cast<double>(s.disparity);
  const glm::dvec3 r = p * glm::dvec3(static_cast<double>(s.u), static_cast<double>(s.v), 1.0);
  const glm::dvec3 along_u = p[0] * d - r * static_cast<double>(s.slope_u);
  const glm::dvec3 along_v = p[1] * d - r * static_cast<double>(s.slope_v);
  return glm::length(glm::cross(along_u, along_v)) / (d * d * d * d);
}

}  // namespace enfilade
