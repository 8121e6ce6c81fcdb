#include "preprocess/watershed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace enfilade {

namespace {

/// Lower envelope of parabolas f[i] + (x − i)², in place.
class LowerEnvelope {
 public:
  void transform(std::vector<double>& f) {
    const int n = static_cast<int>(f.size());
    apex_.assign(f.size(), 0);
    from_.assign(f.size() + 1, 0.0);
    int last = -1;
    for (int q = 0; q < n; ++q) {
      if (std::isinf(f[std::size_t(q)])) continue;
      double s = -std::numeric_limits<double>::infinity();
      while (last >= 0) {
        const int p = apex_[std::size_t(last)];
        s = (f[std::size_t(q)] + double(q) * q - f[std::size_t(p)] - double(p) * p) /
            (2.0 * (q - p));
        if (s > from_[std::size_t(last)]) break;
        --last;
      }
      ++last;
      apex_[std::size_t(last)] = q;
      from_[std::size_t(last)] = last == 0 ? -std::numeric_limits<double>::infinity() : s;
    }
    if (last < 0) return;
    result_.resize(f.size());
    for (int x = 0, k = 0; x < n; ++x) {
      while (k < last && from_[std::size_t(k) + 1] < x) ++k;
      const int p = apex_[std::size_t(k)];
      result_[std::size_t(x)] = f[std::size_t(p)] + double(x - p) * (x - p);
    }
    f = result_;
  }

 private:
  std::vector<int> apex_;
  std::vector<double> from_, result_;
};

class BasinForest {
 public:
  explicit BasinForest(const std::vector<std::int32_t>& squared_distance)
      : parent_(squared_distance.size(), Basins::kNone),
        area_(squared_distance.size(), 1),
        peak_(squared_distance) {}

  bool has(std::size_t pixel) const { return parent_[pixel] != Basins::kNone; }
  void add(std::size_t pixel) { parent_[pixel] = static_cast<std::int32_t>(pixel); }
  std::int32_t find(std::size_t pixel) {
    auto p = static_cast<std::int32_t>(pixel);
    while (parent_[std::size_t(p)] != p) {
      parent_[std::size_t(p)] = parent_[std::size_t(parent_[std::size_t(p)])];
      p = parent_[std::size_t(p)];
    }
    return p;
  }
  /// The root that was seen first keeps its place: its peak is the greater.
  void join(std::int32_t root, std::int32_t other) {
    parent_[std::size_t(other)] = root;
    area_[std::size_t(root)] += area_[std::size_t(other)];
  }
  int areaOf(std::int32_t root) const { return area_[std::size_t(root)]; }
  std::int32_t squaredPeak(std::int32_t root) const { return peak_[std::size_t(root)]; }

 private:
  std::vector<std::int32_t> parent_;
  std::vector<std::int32_t> area_;  // of roots [pixels]
  std::vector<std::int32_t> peak_;
};

/// Of two roots the one with the greater peak; of equals, the lower index.
bool deeper(const BasinForest& forest, std::int32_t a, std::int32_t b) {
  const auto pa = forest.squaredPeak(a), pb = forest.squaredPeak(b);
  return pa != pb ? pa > pb : a < b;
}

/// Adds a pixel to the basin that rises the most steeply from it, and joins the basins that meet
/// here if the neck is wide enough.
void flood(BasinForest& forest, const std::vector<std::int32_t>& squared_distance, int size_x,
           int size_z, std::int32_t pixel, double squared_ratio, std::vector<Neck>& necks) {
  const int x = pixel / size_z, z = pixel % size_z;
  const double here = std::sqrt(double(squared_distance[std::size_t(pixel)]));
  std::vector<std::int32_t> roots;
  std::int32_t steepest = Basins::kNone;
  double steepest_slope = -1;
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dz = -1; dz <= 1; ++dz) {
      const int ox = x + dx, oz = z + dz;
      if (ox < 0 || oz < 0 || ox >= size_x || oz >= size_z || (dx == 0 && dz == 0)) continue;
      const auto other = static_cast<std::size_t>(ox) * static_cast<std::size_t>(size_z) +
                         static_cast<std::size_t>(oz);
      if (!forest.has(other)) continue;
      const std::int32_t root = forest.find(other);
      roots.push_back(root);
      const double rise = std::sqrt(double(squared_distance[other])) - here;
      const double slope = dx != 0 && dz != 0 ? rise * std::sqrt(0.5) : rise;
      if (slope > steepest_slope || (slope == steepest_slope && deeper(forest, root, steepest))) {
        steepest_slope = slope;
        steepest = root;
      }
    }
  }
  forest.add(std::size_t(pixel));
  if (roots.empty()) return;
  std::sort(roots.begin(), roots.end(),
            [&](std::int32_t a, std::int32_t b) { return deeper(forest, a, b); });
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  const double neck = squared_distance[std::size_t(pixel)];
  for (std::size_t i = 1; i < roots.size(); ++i) {
    const double peak = forest.squaredPeak(roots[i]);
    if (neck < squared_ratio * peak) continue;
    necks.push_back(
        {pixel, float(std::sqrt(neck)), float(std::sqrt(neck / peak)), forest.areaOf(roots[i])});
    forest.join(roots[0], roots[i]);
  }
  forest.join(forest.find(std::size_t(steepest)), pixel);
}

}  // namespace

std::vector<std::int32_t> squaredDistance(const std::vector<std::uint8_t>& inside, int size_x,
                                          int size_z) {
  const auto at = [&](int x, int z) {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(size_z) +
           static_cast<std::size_t>(z);
  };
  std::vector<double> squared(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    squared[i] = inside[i] ? std::numeric_limits<double>::infinity() : 0.0;
  }
  LowerEnvelope envelope;
  std::vector<double> line;
  for (int x = 0; x < size_x; ++x) {
    line.assign(squared.begin() + std::ptrdiff_t(at(x, 0)),
                squared.begin() + std::ptrdiff_t(at(x, 0)) + size_z);
    envelope.transform(line);
    std::copy(line.begin(), line.end(), squared.begin() + std::ptrdiff_t(at(x, 0)));
  }
  line.resize(static_cast<std::size_t>(size_x));
  for (int z = 0; z < size_z; ++z) {
    for (int x = 0; x < size_x; ++x) line[std::size_t(x)] = squared[at(x, z)];
    envelope.transform(line);
    for (int x = 0; x < size_x; ++x) squared[at(x, z)] = line[std::size_t(x)];
  }
  std::vector<std::int32_t> result(inside.size());
  constexpr double kMost = 1 << 30;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = static_cast<std::int32_t>(std::min(squared[i], kMost));
  }
  return result;
}

Basins watershed(const std::vector<std::int32_t>& squared_distance, int size_x, int size_z,
                 float merge_ratio) {
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < squared_distance.size(); ++i) {
    if (squared_distance[i] > 0) order.push_back(static_cast<std::int32_t>(i));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return squared_distance[std::size_t(a)] > squared_distance[std::size_t(b)];
  });
  BasinForest forest(squared_distance);
  Basins basins;
  const double squared_ratio = double(merge_ratio) * double(merge_ratio);
  for (const std::int32_t pixel : order) {
    flood(forest, squared_distance, size_x, size_z, pixel, squared_ratio, basins.necks);
  }
  basins.of_pixel.assign(squared_distance.size(), Basins::kNone);
  std::vector<std::int32_t> number(squared_distance.size(), Basins::kNone);
  for (std::size_t i = 0; i < squared_distance.size(); ++i) {
    if (!forest.has(i)) continue;
    const std::int32_t root = forest.find(i);
    auto& basin = number[std::size_t(root)];
    if (basin == Basins::kNone) {
      basin = static_cast<std::int32_t>(basins.peak.size());
      basins.peak.push_back(std::sqrt(static_cast<float>(forest.squaredPeak(root))));
    }
    basins.of_pixel[i] = basin;
  }
  return basins;
}

}  // namespace enfilade
