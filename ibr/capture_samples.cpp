#include "ibr/capture_samples.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "ibr/block_grid.h"

namespace enfilade {
namespace {

/// The gentlest of the slopes from a sample to those of two neighbouring blocks, or 0 if even that
/// one is too steep for a surface: across a silhouette they are.
float gentlestSlope(const BlockGrid& grid, const CaptureSample& at, std::size_t before,
                    std::size_t after, float CaptureSample::*along) {
  constexpr float kLeastStep = 0.25f;  // [pixels] closer samples say little about the slope
  constexpr float kSteepest = 0.1f;    // [of the disparity, per pixel]
  const float steepest = kSteepest * at.disparity;
  float gentlest = steepest;
  for (const std::size_t block : {before, after}) {
    for (std::uint32_t i = grid.first[block]; i < grid.first[block + 1]; ++i) {
      const CaptureSample& other = grid.samples[i];
      const float step = other.*along - at.*along;
      const float slope = (other.disparity - at.disparity) / step;
      // No branch on which is gentler: on a smooth surface that is chance.
      const int is_gentler = std::abs(slope) < std::abs(gentlest);
      const int is_apart = std::abs(step) >= kLeastStep;
      gentlest = (is_gentler & is_apart) != 0 ? slope : gentlest;
    }
  }
  return gentlest == steepest ? 0.0f : gentlest;
}

}  // namespace

CaptureSamples resolveCapture(const DepthImage& fine, int rays, float threshold) {
  assert(rays >= 1 && rays <= 4);
  assert(fine.camera.width % rays == 0 && fine.camera.height % rays == 0);
  BlockGrid grid = gridOfBlocks(fine, rays, threshold);
  for (std::size_t i = grid.stride; i + grid.stride + 1 < grid.first.size(); ++i) {
    for (std::uint32_t k = grid.first[i]; k < grid.first[i + 1]; ++k) {
      CaptureSample& s = grid.samples[k];
      s.slope_u = gentlestSlope(grid, s, i - 1, i + 1, &CaptureSample::u);
      s.slope_v = gentlestSlope(grid, s, i - grid.stride, i + grid.stride, &CaptureSample::v);
    }
  }
  CaptureSamples capture;
  capture.camera = fine.camera;
  capture.camera.world_from_pixel[0] *= rays;
  capture.camera.world_from_pixel[1] *= rays;
  capture.camera.width = fine.camera.width / rays;
  capture.camera.height = fine.camera.height / rays;
  capture.samples = std::move(grid.samples);
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
