// Floors, stones, woods and ground: patterns that repeat both ways.
#include <algorithm>
#include <cmath>

#include "models/noise.h"
#include "models/patterns.h"

namespace enfilade {
namespace {

/// A cell of a tiling: which one, and how far the point lies from its edges (0 at the edge).
struct Tile {
  std::int64_t x = 0, y = 0;
  glm::dvec2 in{0};  // 0…1 inside it
  double edge = 0;   // distance to the nearest edge, in tiles
};

Tile tileAt(const glm::dvec2& p, int across, int down) {
  const glm::dvec2 cell = glm::floor(p);
  Tile tile;
  tile.x = ((static_cast<std::int64_t>(cell.x) % across) + across) % across;
  tile.y = ((static_cast<std::int64_t>(cell.y) % down) + down) % down;
  tile.in = p - cell;
  tile.edge = std::min({tile.in.x, 1 - tile.in.x, tile.in.y, 1 - tile.in.y});
  return tile;
}

glm::dvec3 lit(const glm::dvec3& color, double amount) { return color * (1 + amount); }

/// Veins: the zero lines of warped noise.
double veins(std::uint32_t seed, const glm::dvec2& uv, int period) {
  const glm::dvec2 p = uv * double(period);
  const glm::dvec2 warp(fractal2(seed + 11, p, 4, period), fractal2(seed + 23, p, 4, period));
  const double line = std::abs(fractal2(seed, p + 1.1 * warp, 4, period));
  return 1 - ramp(0, 0.055, line);
}

glm::dvec3 marbleAt(const glm::dvec3& base, const glm::dvec3& vein, std::uint32_t seed,
                    const glm::dvec2& uv) {
  const double cloud = fractal2(seed + 5, uv * 4.0, 4, 4);
  return glm::mix(lit(base, 0.10 * cloud), vein, 0.55 * veins(seed, uv, 4));
}

double grain(std::uint32_t seed, double along, double across) {
  return 0.6 * fractal2(seed, {along, 9 * across}, 4) +
         0.4 * noise2(seed + 3, {2 * along, 60 * across});
}

glm::dvec3 parquet(const PlanFinish& f, const glm::dvec2& uv) {
  // Herringbone: planks four cells long; cell (i, j) tells plank and direction by i − j.
  constexpr int kCells = 16, kLong = 4;
  const glm::dvec2 p = uv * double(kCells);
  const auto i = static_cast<std::int64_t>(p.x), j = static_cast<std::int64_t>(p.y);
  const auto m = (((i - j) % (2 * kLong)) + 2 * kLong) % (2 * kLong);
  const bool flat = m < kLong;
  const std::int64_t step = flat ? m : 2 * kLong - 1 - m;
  const std::int64_t px = ((flat ? i - step : i) + kCells) % kCells,
                     py = ((flat ? j : j - step) + kCells) % kCells;
  const glm::dvec2 in = p - glm::floor(p);
  const double along = static_cast<double>(step) + (flat ? in.x : in.y),
               across = flat ? in.y : in.x;
  const double edge = std::min({across, 1 - across, along, kLong - along});
  const auto seed = f.seed + static_cast<std::uint32_t>(px * 131 + py * 17 + (flat ? 7 : 0));
  const glm::dvec3 wood = glm::mix(colorOf(f, 0), colorOf(f, 1), hash01(seed, px, py, flat));
  return lit(wood, 0.16 * grain(seed, along, across)) * (0.55 + 0.45 * ramp(0, 0.07, edge));
}

glm::dvec3 planks(const PlanFinish& f, const glm::dvec2& uv) {
  constexpr int kBoards = 8;
  const double row = uv.y * kBoards;
  const auto j = static_cast<std::int64_t>(row);
  const double shift = hash01(f.seed, j, 99), along = uv.x * 2 + shift;
  const auto i = static_cast<std::int64_t>(along) % 2;
  const double across = row - std::floor(row), in = along - std::floor(along);
  const double edge = std::min({across, 1 - across, 12 * in, 12 * (1 - in)});
  const auto seed = f.seed + static_cast<std::uint32_t>(j * 31 + i * 7);
  const glm::dvec3 wood = glm::mix(colorOf(f, 0), colorOf(f, 1), hash01(seed, i, j));
  return lit(wood, 0.16 * grain(seed, 6 * in, across)) * (0.55 + 0.45 * ramp(0, 0.06, edge));
}

glm::dvec3 checker(const PlanFinish& f, const glm::dvec2& uv) {
  const Tile t = tileAt(uv * 4.0, 4, 4);
  const std::size_t which = static_cast<std::size_t>((t.x + t.y) % 2);
  const auto seed = f.seed + static_cast<std::uint32_t>(t.x * 53 + t.y * 19);
  const glm::dvec3 vein = which == 0 ? colorOf(f, 0) * 0.72 : colorOf(f, 1) * 0.5 + 0.35;
  const glm::dvec3 stone = marbleAt(colorOf(f, which), vein, seed, t.in * 0.6);
  return glm::mix(colorOf(f, 2), stone, ramp(0.006, 0.02, t.edge));
}

/// Octagons with small squares set at their corners.
glm::dvec3 octagons(const PlanFinish& f, const glm::dvec2& uv) {
  const Tile t = tileAt(uv * 4.0, 4, 4);
  const glm::dvec2 away = glm::min(t.in, 1.0 - t.in);
  const double square = 0.3 - (away.x + away.y);  // > 0 within the small square
  const auto seed = f.seed + static_cast<std::uint32_t>(t.x * 53 + t.y * 19);
  const double edge = square > 0 ? square : std::min(t.edge, -square * 0.7);
  const glm::dvec3 stone = square > 0
                               ? lit(colorOf(f, 1), 0.15 * fractal2(f.seed, uv * 32.0, 3, 32))
                               : marbleAt(colorOf(f, 0), colorOf(f, 0) * 0.75, seed, t.in * 0.6);
  return glm::mix(colorOf(f, 2), stone, ramp(0.006, 0.022, edge));
}

glm::dvec3 terracotta(const PlanFinish& f, const glm::dvec2& uv) {
  glm::dvec2 p = uv * 6.0;
  p.x += 0.5 * static_cast<double>(static_cast<std::int64_t>(std::floor(p.y)) % 2);
  const Tile t = tileAt(p, 6, 6);
  const double age =
      0.10 * fractal2(f.seed, uv * 24.0, 4, 24) + 0.10 * (hash01(f.seed + 1, t.x, t.y) - 0.5);
  const glm::dvec3 clay =
      lit(glm::mix(colorOf(f, 0), colorOf(f, 1), hash01(f.seed, t.x, t.y)), age);
  return glm::mix(colorOf(f, 2), clay * (0.85 + 0.15 * ramp(0, 0.12, t.edge)),
                  ramp(0.018, 0.04, t.edge));
}

glm::dvec3 terrazzo(const PlanFinish& f, const glm::dvec2& uv) {
  constexpr int kChips = 30;
  const glm::dvec2 p = uv * double(kChips);
  double nearest = 9, second = 9;
  glm::i64vec2 best(0);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::i64vec2 c(static_cast<std::int64_t>(p.x) + dx,
                           static_cast<std::int64_t>(p.y) + dy);
      const glm::i64vec2 w((c.x + kChips) % kChips, (c.y + kChips) % kChips);
      const glm::dvec2 at =
          glm::dvec2(c) + glm::dvec2(hash01(f.seed, w.x, w.y), hash01(f.seed + 1, w.x, w.y));
      const double d = glm::distance(at, p);
      if (d < nearest) best = w;
      second = std::min(second, std::max(d, nearest));
      nearest = std::min(nearest, d);
    }
  }
  const double pick = hash01(f.seed + 2, best.x, best.y);
  const glm::dvec3 chip = colorOf(f, 1 + static_cast<std::size_t>(pick * 2.999));
  const double big = 0.10 + 0.25 * hash01(f.seed + 3, best.x, best.y);
  return glm::mix(colorOf(f, 0), chip, ramp(big, big + 0.12, second - nearest));
}

glm::dvec3 marble(const PlanFinish& f, const glm::dvec2& uv) {
  return marbleAt(colorOf(f, 0), colorOf(f, 1), f.seed, uv);
}

glm::dvec3 plaster(const PlanFinish& f, const glm::dvec2& uv) {
  return lit(colorOf(f, 0), 0.05 * fractal2(f.seed, uv * 8.0, 5, 8));
}

glm::dvec3 ashlar(const PlanFinish& f, const glm::dvec2& uv) {
  glm::dvec2 p = uv * glm::dvec2(2, 4);
  p.x += 0.5 * static_cast<double>(static_cast<std::int64_t>(std::floor(p.y)) % 2);
  const Tile t = tileAt(p, 2, 4);
  const double edge = std::min({2 * t.in.x, 2 * (1 - t.in.x), t.in.y, 1 - t.in.y});
  const double stain =
      0.07 * fractal2(f.seed, uv * 12.0, 5, 12) + 0.07 * (hash01(f.seed, t.x, t.y) - 0.5);
  return lit(colorOf(f, 0), stain) * (0.72 + 0.28 * ramp(0.01, 0.04, edge));
}

glm::dvec3 wood(const PlanFinish& f, const glm::dvec2& uv) {
  const double ring = fractal2(f.seed, uv * glm::dvec2(16, 2), 4, 0);
  const double seam = 0.5 - 0.5 * std::cos(6.283185307179586 * uv.x);
  return glm::mix(colorOf(f, 0), colorOf(f, 1), 0.5 + 0.9 * ring * seam);
}

/// Figures in the second colour on glaze of the first: blossoms between bands.
glm::dvec3 porcelain(const PlanFinish& f, const glm::dvec2& uv) {
  const Tile t = tileAt(uv * glm::dvec2(6, 6), 6, 6);
  const glm::dvec2 c = t.in - 0.5;
  const double petals = 4 + std::floor(3 * hash01(f.seed, t.x, t.y));
  const double angle = std::atan2(c.y, c.x) + 6 * hash01(f.seed + 1, t.x, t.y);
  const double flower = glm::length(c) - 0.26 * (1 + 0.4 * std::cos(petals * angle));
  const double stem = std::abs(c.x - 0.18 * std::sin(6.283185307179586 * t.in.y));
  const double band = t.y % 3 == 0 ? ramp(0.02, 0.06, t.in.y) * (1 - ramp(0.1, 0.14, t.in.y)) : 0;
  const double figure =
      std::max({1 - ramp(0, 0.06, flower), 0.7 * (1 - ramp(0.02, 0.05, stem)), band});
  return glm::mix(lit(colorOf(f, 0), 0.03 * fractal2(f.seed, uv * 6.0, 3, 6)), colorOf(f, 1),
                  0.85 * figure);
}

glm::dvec3 gilt(const PlanFinish& f, const glm::dvec2& uv) {
  const double worn = fractal2(f.seed, uv * 16.0, 4, 16);
  return glm::mix(lit(colorOf(f, 0), 0.35 * worn), colorOf(f, 1), ramp(0.2, 0.6, worn));
}

glm::dvec3 grass(const PlanFinish& f, const glm::dvec2& uv) {
  const double blades = fractal2(f.seed, uv * 48.0, 3, 48),
               clumps = fractal2(f.seed + 9, uv * 5.0, 4, 5);
  return lit(glm::mix(colorOf(f, 0), colorOf(f, 1), 0.5 + 0.7 * clumps), 0.28 * blades);
}

glm::dvec3 leaves(const PlanFinish& f, const glm::dvec2& uv) {
  const double a = fractal2(f.seed, uv * 12.0, 4, 12), b = fractal2(f.seed + 9, uv * 24.0, 2, 24);
  return lit(glm::mix(colorOf(f, 0), colorOf(f, 1), ramp(-0.4, 0.4, a)), 0.5 * b);
}

glm::dvec3 gravel(const PlanFinish& f, const glm::dvec2& uv) {
  const double stones = noise2(f.seed, uv * 64.0, 64), fine = noise2(f.seed + 4, uv * 128.0, 128);
  return lit(glm::mix(colorOf(f, 0), colorOf(f, 1), 0.5 + 0.5 * stones), 0.12 * fine);
}

}  // namespace

std::vector<PatternKind> materialPatterns() {
  return {
      {"parquet", 512, 512, parquet},
      {"planks", 512, 512, planks},
      {"checker", 512, 512, checker},
      {"octagons", 512, 512, octagons},
      {"terracotta", 512, 512, terracotta},
      {"terrazzo", 512, 512, terrazzo},
      {"marble", 256, 256, marble},
      {"plaster", 256, 256, plaster},
      {"ashlar", 512, 512, ashlar},
      {"wood", 256, 256, wood},
      {"gilt", 128, 128, gilt},
      {"porcelain", 256, 256, porcelain},
      {"grass", 512, 512, grass},
      {"leaves", 256, 256, leaves},
      {"gravel", 256, 256, gravel},
  };
}

}  // namespace enfilade
