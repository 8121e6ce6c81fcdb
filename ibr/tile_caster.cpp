// Rafferty, Aliaga, Popescu & Lastra, Images for Accelerating Architectural Walkthroughs, 1998,
// sec. 3.2, Figure 4a.
#include "ibr/tile_caster.h"

#include <algorithm>

namespace enfilade {

std::vector<LooseSample> TileCaster::cast(int x, int y) {
  std::vector<LooseSample> samples;
  for (int row = 0; row < kLdiTile; ++row) {
    for (int column = 0; column < kLdiTile; ++column) {
      gatherPoints({x * kLdiTile + column, y * kLdiTile + row});
      while (!points_.empty()) {
        takeNearestSurface({column, row}, samples);
      }
    }
  }
  return samples;
}

/// All points on the rays of a pixel, farthest first.
void TileCaster::gatherPoints(const glm::ivec2& pixel) {
  points_.clear();
  const glm::dmat3& p = casting_.central.world_from_pixel;
  for (int y = 0; y < casting_.rays; ++y) {
    for (int x = 0; x < casting_.rays; ++x) {
      const double u = pixel.x + (x + 0.5) / casting_.rays;
      const double v = pixel.y + (y + 0.5) / casting_.rays;
      surfaces_.clear();
      casting_.caster.surfacesOn(
          {glm::vec3(casting_.central.center), glm::vec3(p * glm::dvec3(u, v, 1)),
           glm::vec3(p[0] / static_cast<double>(casting_.rays)),
           glm::vec3(p[1] / static_cast<double>(casting_.rays)), 1.0f,
           static_cast<float>(casting_.most)},
          surfaces_);
      for (const SurfaceOnRay& s : surfaces_) {
        if (s.object >= casting_.candidates.size() || casting_.candidates[s.object] == 0) continue;
        points_.push_back(
            {{u, v, 1.0 / static_cast<double>(s.distance), glm::dvec3(s.normal), s.one_sided},
             x,
             y});
      }
      points_.push_back({{u, v, 1.0 / casting_.most, glm::dvec3(0), false}, x, y});
    }
  }
  std::stable_sort(points_.begin(), points_.end(), [](const FinePoint& a, const FinePoint& b) {
    return a.at.disparity < b.at.disparity;
  });
}

/// Takes the nearest surface from the points; a sample of it if a viewpoint sees it.
void TileCaster::takeNearestSurface(const glm::ivec2& pixel, std::vector<LooseSample>& samples) {
  const double nearest = points_.back().at.disparity;
  std::size_t first = points_.size() - 1;
  while (first > 0 &&
         nearest - points_[first - 1].at.disparity <= static_cast<double>(casting_.threshold))
    --first;
  auto eye = casting_.sight_lines.bestEye(points_.back().at);
  if (!eye && first + 1 < points_.size()) eye = casting_.sight_lines.bestEye(points_[first].at);
  if (eye) addSample(*eye, first, pixel, samples);
  points_.resize(first);
}

/// The mean of the points from `first` on that `eye` sees.
void TileCaster::addSample(std::size_t eye, std::size_t first, const glm::ivec2& pixel,
                           std::vector<LooseSample>& samples) const {
  glm::ivec3 color(0);
  glm::ivec2 least(casting_.rays), greatest(-1);
  glm::dvec3 sum(0);
  int seen = 0;
  for (std::size_t i = first; i < points_.size(); ++i) {
    const FinePoint& point = points_[i];
    const auto shows = casting_.sight_lines.colorFrom(eye, point.at);
    if (!shows) continue;
    color += glm::ivec3(*shows);
    least = glm::min(least, glm::ivec2(point.x, point.y));
    greatest = glm::max(greatest, glm::ivec2(point.x, point.y));
    sum += glm::dvec3(point.x + 0.5, point.y + 0.5, point.at.disparity);
    ++seen;
  }
  const glm::ivec3 mean = (color + seen / 2) / seen;
  LooseSample s;
  s.x = static_cast<float>(pixel.x + sum.x / (seen * casting_.rays));
  s.y = static_cast<float>(pixel.y + sum.y / (seen * casting_.rays));
  s.disparity = static_cast<float>(sum.z / seen);
  s.across = static_cast<float>(greatest.x - least.x + 1) / static_cast<float>(casting_.rays);
  s.down = static_cast<float>(greatest.y - least.y + 1) / static_cast<float>(casting_.rays);
  s.r = static_cast<std::uint8_t>(mean.r);
  s.g = static_cast<std::uint8_t>(mean.g);
  s.b = static_cast<std::uint8_t>(mean.b);
  samples.push_back(s);
}

}  // namespace enfilade
