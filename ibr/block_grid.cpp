#include "ibr/block_grid.h"

#include <algorithm>
#include <array>

namespace enfilade {
namespace {

/// The pixels of a block, at most 4 × 4, where something is known.
struct Block {
  struct Pixel {
    int x, y;
    float disparity;
  };
  std::array<Pixel, 16> pixels;  // the first `count`
  std::size_t count = 0;
};

std::size_t indexOf(const DepthImage& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.camera.width) +
         static_cast<std::size_t>(x);
}

/// The mean of some pixels of one surface.
class SurfaceMean {
 public:
  void add(const DepthImage& fine, int x, int y, float disparity) {
    const std::uint8_t* rgba = &fine.color.rgba[4 * indexOf(fine, x, y)];
    for (std::size_t c = 0; c < 3; ++c) {
      color_[c] += rgba[c];
    }
    least_ = glm::min(least_, glm::ivec2(x, y));
    greatest_ = glm::max(greatest_, glm::ivec2(x, y));
    x_ += x;
    y_ += y;
    disparity_ += static_cast<double>(disparity);
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
    const Block::Pixel& pixel = block.pixels[i];
    if (nearest - pixel.disparity <= threshold) {
      mean.add(fine, pixel.x, pixel.y, pixel.disparity);
    } else {
      block.pixels[left++] = pixel;
    }
  }
  block.count = left;
  return mean.sample(rays);
}

/// Whether all pixels of a block show one surface, which is so nearly everywhere.
template <int kRays>
bool isOneSurface(const float* corner, std::size_t stride, float threshold) {
  float least = corner[0];
  float greatest = corner[0];
  for (int y = 0; y < kRays; ++y) {
    for (int x = 0; x < kRays; ++x) {
      const float disparity =
          corner[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)];
      least = std::min(least, disparity);
      greatest = std::max(greatest, disparity);
    }
  }
  return least > 0.0f && greatest - least <= threshold;
}

/// What SurfaceMean makes of all pixels of a block, its middle aside.
template <int kRays>
CaptureSample meanOfAll(const float* disparity, const std::uint8_t* rgba, std::size_t stride) {
  constexpr int kPixels = kRays * kRays;
  std::array<int, 3> color{};
  double sum = 0.0;
  for (std::size_t y = 0; y < kRays; ++y) {
    for (std::size_t x = 0; x < kRays; ++x) {
      const std::size_t pixel = y * stride + x;
      sum += static_cast<double>(disparity[pixel]);
      for (std::size_t c = 0; c < 3; ++c) color[c] += rgba[4 * pixel + c];
    }
  }
  CaptureSample s;
  s.disparity = static_cast<float>(sum * (1.0 / kPixels));
  s.r = static_cast<std::uint8_t>((color[0] + kPixels / 2) / kPixels);
  s.g = static_cast<std::uint8_t>((color[1] + kPixels / 2) / kPixels);
  s.b = static_cast<std::uint8_t>((color[2] + kPixels / 2) / kPixels);
  return s;
}

/// Appends the samples of a block that shows more than one surface, or not everything.
void addSurfaces(const DepthImage& fine, int column, int row, int rays, float threshold,
                 std::vector<CaptureSample>& samples) {
  Block block;
  for (int y = row * rays; y < (row + 1) * rays; ++y) {
    for (int x = column * rays; x < (column + 1) * rays; ++x) {
      const float disparity = fine.disparity[indexOf(fine, x, y)];
      if (disparity > 0.0f) {
        block.pixels[block.count++] = {x, y, disparity};
      }
    }
  }
  while (block.count > 0) {
    samples.push_back(takeNearestSurface(fine, block, rays, threshold));
  }
}

template <int kRays>
void addRow(const DepthImage& fine, int row, float threshold, BlockGrid& grid) {
  const auto stride = static_cast<std::size_t>(fine.camera.width);
  const int width = fine.camera.width / kRays;
  for (int column = 0; column < width; ++column) {
    grid.first.push_back(static_cast<std::uint32_t>(grid.samples.size()));
    const std::size_t corner = indexOf(fine, column * kRays, row * kRays);
    if (isOneSurface<kRays>(&fine.disparity[corner], stride, threshold)) {
      grid.samples.push_back(
          meanOfAll<kRays>(&fine.disparity[corner], &fine.color.rgba[4 * corner], stride));
      grid.samples.back().u = static_cast<float>(column) + 0.5f;
      grid.samples.back().v = static_cast<float>(row) + 0.5f;
    } else {
      addSurfaces(fine, column, row, kRays, threshold, grid.samples);
    }
  }
}

}  // namespace

BlockGrid gridOfBlocks(const DepthImage& fine, int rays, float threshold) {
  constexpr std::array kAddRow = {&addRow<1>, &addRow<2>, &addRow<3>, &addRow<4>};
  const auto width = static_cast<std::size_t>(fine.camera.width / rays);
  const int height = fine.camera.height / rays;
  BlockGrid grid;
  grid.stride = width + 2;
  const auto blocks = grid.stride * (static_cast<std::size_t>(height) + 2);
  grid.first.reserve(blocks + 1);
  grid.samples.reserve(blocks + blocks / 8);
  const auto addEmpty = [&](std::size_t n) {
    grid.first.insert(grid.first.end(), n, static_cast<std::uint32_t>(grid.samples.size()));
  };
  addEmpty(grid.stride);
  for (int row = 0; row < height; ++row) {
    addEmpty(1);
    kAddRow[static_cast<std::size_t>(rays) - 1](fine, row, threshold, grid);
    addEmpty(1);
  }
  addEmpty(grid.stride + 1);
  return grid;
}

}  // namespace enfilade
