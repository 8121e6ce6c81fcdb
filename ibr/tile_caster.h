#pragma once

#include <vector>

#include "ibr/ldi_packing.h"
#include "ibr/sight_lines.h"

namespace enfilade {

/// What the tiles of a layered depth image by rays are made from.
struct TileCasting {
  const RayCaster& caster;
  const PlanarCamera& central;
  const SightLines& sight_lines;         ///< of points in `central`
  std::vector<std::uint8_t> candidates;  ///< one flag an object: whether it may be seen at all
  int rays;                              ///< a pixel, across and down
  float threshold;  ///< points of a pixel whose disparities differ by no more show one surface
  double most;      ///< [distances to the image plane] of the sky
};

/// Casts the rays of one tile after another, on one thread.
class TileCaster {
 public:
  /// Keeps a reference.
  explicit TileCaster(const TileCasting& casting) : casting_(casting) {}

  /// The samples of tile (x, y), counted from the central image's corner; those of a pixel nearest
  /// first.
  std::vector<LooseSample> cast(int x, int y);

 private:
  /// A point on one of a pixel's rays.
  struct FinePoint {
    RayPoint at;
    int x = 0, y = 0;  ///< its ray's, of the pixel's
  };
  void gatherPoints(const glm::ivec2& pixel);
  void takeNearestSurface(const glm::ivec2& pixel, std::vector<LooseSample>& samples);
  void addSample(std::size_t eye, std::size_t first, const glm::ivec2& pixel,
                 std::vector<LooseSample>& samples) const;

  const TileCasting& casting_;
  std::vector<SurfaceOnRay> surfaces_;  ///< of a ray
  std::vector<FinePoint> points_;       ///< of a pixel that are left, farthest first
};

}  // namespace enfilade
