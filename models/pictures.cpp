// Pictures to hang on walls, each of its finish's seed and colours (sky, land, light …).
#include <algorithm>
#include <cmath>

#include "models/noise.h"
#include "models/patterns.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;

/// Brush strokes: colour wavers across the canvas.
glm::dvec3 brushed(const glm::dvec3& color, std::uint32_t seed, const glm::dvec2& uv) {
  const double stroke = fractal2(seed + 71, uv * glm::dvec2(18, 40), 3);
  return color * (1 + 0.13 * stroke);
}

glm::dvec3 skyAt(const PlanFinish& f, const glm::dvec2& uv) {
  const glm::dvec3 sky = glm::mix(colorOf(f, 0), colorOf(f, 2), ramp(0.05, 0.6, uv.y));
  const double cloud = fractal2(f.seed + 5, uv * glm::dvec2(4, 9), 5);
  return glm::mix(sky, glm::dvec3(0.97, 0.94, 0.88), 0.6 * ramp(0.05, 0.4, cloud));
}

glm::dvec3 landscape(const PlanFinish& f, const glm::dvec2& uv) {
  glm::dvec3 color = skyAt(f, uv);
  for (int layer = 0; layer < 5; ++layer) {
    const double depth = layer / 4.0;
    const double crest =
        0.42 + 0.13 * layer +
        (0.16 - 0.03 * layer) * fractal2(f.seed + static_cast<std::uint32_t>(layer) * 13,
                                         {uv.x * (2.5 + layer), 3.7 * layer}, 5);
    const double trees = 0.02 * depth * noise2(f.seed + 41, {uv.x * 70, layer * 5.0});
    const glm::dvec3 hill =
        glm::mix(glm::mix(colorOf(f, 2), colorOf(f, 1), 0.35), colorOf(f, 1) * 0.75, depth);
    const double field = 0.25 * fractal2(f.seed + 17, uv * glm::dvec2(8, 30), 4);
    color = glm::mix(color, hill * (1 + field), ramp(-0.004, 0.004, uv.y - crest - trees));
  }
  return brushed(color, f.seed, uv);
}

glm::dvec3 seascape(const PlanFinish& f, const glm::dvec2& uv) {
  const double horizon = 0.55;
  const glm::dvec2 sun(0.25 + 0.5 * hash01(f.seed, 1), 0.38);
  const double glow = std::exp(-14 * glm::length((uv - sun) * glm::dvec2(1, 1.2)));
  glm::dvec3 color = glm::mix(skyAt(f, uv), glm::dvec3(1, 0.9, 0.65), glow);
  if (uv.y > horizon) {
    const double far = (uv.y - horizon) / (1 - horizon);
    const double wave = fractal2(f.seed + 3, {uv.x * 9 / (0.12 + far), 14 / (0.12 + far)}, 4);
    const double path = std::exp(-40 * (uv.x - sun.x) * (uv.x - sun.x) / (0.3 + far));
    color = glm::mix(glm::mix(colorOf(f, 2), colorOf(f, 1), ramp(0, 0.5, far)) * (1 + 0.45 * wave),
                     glm::dvec3(1, 0.88, 0.62), 0.7 * path * ramp(0, 0.3, wave + 0.15));
  }
  // A ship with two sails.
  const glm::dvec2 s = (uv - glm::dvec2(0.3 + 0.45 * hash01(f.seed, 2), 0.56)) / 0.13;
  const bool hull = s.y > -0.05 && s.y < 0.2 && std::abs(s.x) < 0.75 - s.y;
  const bool sail = s.y < -0.1 && s.y > -1.5 && s.x > 0.03 && s.x < 0.75 * (1.5 + s.y) / 1.4;
  const bool jib = s.y < -0.1 && s.y > -1.2 && s.x < -0.03 && -s.x < 0.6 * (1.2 + s.y) / 1.1;
  if (hull) color = glm::dvec3(0.2, 0.13, 0.1);
  if (sail || jib) color = glm::dvec3(0.93, 0.89, 0.8) * (sail ? 1.0 : 0.9);
  return brushed(color, f.seed, uv);
}

/// Lays `paint` over `under` where `distance` is below 0, with a soft edge.
glm::dvec3 over(const glm::dvec3& under, const glm::dvec3& paint, double distance,
                double soft = 0.01) {
  return glm::mix(under, paint, 1 - ramp(-0.5 * soft, 0.5 * soft, distance));
}

/// Eyes, brows, nose and mouth; `p` from the middle of the face, y down.
glm::dvec3 faceAt(glm::dvec3 color, const glm::dvec2& p) {
  for (const double side : {-1.0, 1.0}) {
    const double dx = p.x - side * 0.052;
    const glm::dvec2 e = glm::dvec2(dx, p.y + 0.015) * glm::dvec2(1, 2.1);
    color = over(color, {0.95, 0.93, 0.9}, glm::length(e) - 0.021, 0.006);
    color = over(color, {0.12, 0.08, 0.06}, glm::length(e * glm::dvec2(1, 0.6)) - 0.011, 0.004);
    const double brow = std::max(std::abs(p.y + 0.056 - 7 * dx * dx) - 0.004, std::abs(dx) - 0.03);
    color = over(color, color * 0.45, brow, 0.006);
  }
  const double ridge = std::abs(p.x - 0.008 - 0.12 * std::max(p.y, 0.0));
  if (p.y > -0.01 && p.y < 0.055) color *= 1 - 0.3 * (1 - ramp(0, 0.012, ridge));
  const glm::dvec2 mouth = glm::dvec2(p.x, p.y - 0.095 + 3 * p.x * p.x) * glm::dvec2(1, 5);
  return over(color, {0.62, 0.25, 0.22}, glm::length(mouth) - 0.039);
}

/// Head and shoulders before a dark ground.
glm::dvec3 portrait(const PlanFinish& f, const glm::dvec2& uv) {
  const glm::dvec2 p = (uv - glm::dvec2(0.5, 0.42)) * glm::dvec2(1.0, 1.15);
  const double vignette = 1 - 0.7 * glm::length(uv - 0.5);
  glm::dvec3 color = colorOf(f, 0) * vignette * (1 + 0.3 * fractal2(f.seed, uv * 5.0, 4));
  const double shoulder = p.y - 0.26 - 0.9 * p.x * p.x + 0.04 * std::abs(p.x);
  const double folds = fractal2(f.seed + 2, uv * glm::dvec2(14, 5), 4);
  color = over(color, colorOf(f, 1) * (0.8 + 0.5 * folds), -shoulder, 0.02);
  const double collar = std::abs(shoulder - 0.015 - 0.02 * std::cos(60 * p.x)) - 0.025;
  color = over(color, {0.93, 0.9, 0.85}, std::max(collar, std::abs(p.x) - 0.16));
  const glm::dvec3 skin = glm::dvec3(0.86, 0.66, 0.53) * (1.06 - 0.9 * ramp(-0.05, 0.2, p.x));
  color = over(color, skin * 0.85, std::max(std::abs(p.x) - 0.065, std::abs(p.y - 0.2) - 0.1));
  const double strands = fractal2(f.seed + 4, uv * glm::dvec2(40, 9), 3);
  const double hair = glm::length(p * glm::dvec2(1, 0.85) + glm::dvec2(0, 0.055)) - 0.185;
  color = over(color, colorOf(f, 2) * (0.8 + 0.6 * strands), hair, 0.02);
  color = over(color, skin, glm::length(p * glm::dvec2(1.25, 0.9)) - 0.155, 0.016);
  return brushed(faceAt(color, p), f.seed, uv);
}

/// A round fruit lit from the upper left; `d` from its middle, in radii, within 1.
glm::dvec3 fruitAt(double hue, const glm::dvec2& d) {
  const glm::dvec3 skin = hue < 0.35  ? glm::dvec3(0.8, 0.2, 0.12)
                          : hue < 0.6 ? glm::dvec3(0.95, 0.6, 0.15)
                          : hue < 0.8 ? glm::dvec3(0.55, 0.62, 0.18)
                                      : glm::dvec3(0.35, 0.16, 0.35);
  const double toward = std::sqrt(1 - glm::dot(d, d));
  const double light = std::clamp(-0.55 * d.x - 0.6 * d.y + 0.6 * toward, 0.0, 1.0);
  return skin * (0.25 + 0.85 * light) + glm::dvec3(0.5) * std::pow(light, 24.0);
}

glm::dvec3 stillLife(const PlanFinish& f, const glm::dvec2& uv) {
  const double fold = fractal2(f.seed, uv * glm::dvec2(9, 3), 4);
  const double wall = 0.8 + 0.4 * fractal2(f.seed + 1, uv * 4.0, 4) + 0.3 * (1 - uv.x);
  const bool table = uv.y > 0.66 + 0.02 * std::sin(9 * uv.x);
  glm::dvec3 color = table ? colorOf(f, 2) * (0.85 + 0.5 * fold) : colorOf(f, 0) * wall;
  for (std::int64_t i = 0; i < 9; ++i) {
    const double r = 0.055 + 0.05 * hash01(f.seed, i, 0);
    const double x = 0.14 + 0.72 * hash01(f.seed, i, 1);
    const glm::dvec2 c(x, 0.70 - r + 0.14 * static_cast<double>(i) / 9), d = (uv - c) / r;
    const glm::dvec2 shadow = (d - glm::dvec2(0.5, 0.9)) / glm::dvec2(1.4, 0.35);
    color *= 0.55 + 0.45 * ramp(0.5, 1.0, glm::length(shadow));
    if (glm::length(d) <= 1) color = fruitAt(hash01(f.seed, i, 2), d);
  }
  return brushed(color, f.seed, uv);
}

/// Rectangles cut again and again, some of them coloured, between black bars.
glm::dvec3 blocks(const PlanFinish& f, const glm::dvec2& uv) {
  glm::dvec2 low(0), high(1);
  double edge = 1;
  std::int64_t key = 1;
  for (int depth = 0; depth < 5; ++depth) {
    const int axis = high.x - low.x > high.y - low.y ? 0 : 1;
    if (depth > 1 && hash01(f.seed, key, 9) < 0.25) break;
    const double cut = glm::mix(low[axis], high[axis], 0.25 + 0.5 * hash01(f.seed, key, axis));
    edge = std::min(edge, std::abs(uv[axis] - cut));
    const bool upper = uv[axis] > cut;
    (upper ? low : high)[axis] = cut;
    key = 2 * key + (upper ? 1 : 0);
  }
  const double pick = hash01(f.seed, key, 7);
  const glm::dvec3 paper(0.93, 0.91, 0.85);
  const glm::dvec3 color =
      pick < 0.5 ? paper : colorOf(f, static_cast<std::size_t>((pick - 0.5) * 5.99));
  return brushed(glm::mix(glm::dvec3(0.07), color, ramp(0.006, 0.012, edge)), f.seed, uv);
}

/// Rings within squares, each square of other colours.
glm::dvec3 circles(const PlanFinish& f, const glm::dvec2& uv) {
  const glm::dvec2 p = uv * glm::dvec2(4, 3), cell = glm::floor(p);
  const auto i = static_cast<std::int64_t>(cell.x), j = static_cast<std::int64_t>(cell.y);
  const glm::dvec2 d = p - cell - 0.5;
  const double wobble = 0.05 * fractal2(f.seed + 6, p * 2.0, 3);
  const auto ring = static_cast<std::int64_t>(std::min((glm::length(d) + wobble) / 0.115, 5.0));
  const double a = hash01(f.seed, i, j, ring), b = hash01(f.seed + 1, i, j, ring);
  const glm::dvec3 color =
      glm::mix(colorOf(f, static_cast<std::size_t>(3.99 * a)),
               0.5 + 0.5 * glm::cos(kTau * (b + glm::dvec3(0, 0.33, 0.67))), 0.35);
  return brushed(color, f.seed, uv);
}

/// Fields of colour that bleed into one another.
glm::dvec3 fields(const PlanFinish& f, const glm::dvec2& uv) {
  const double ragged = 0.02 * fractal2(f.seed, uv * 9.0, 4);
  const double frame = std::min({uv.x, 1 - uv.x, uv.y, 1 - uv.y}) + ragged;
  const double split = 0.35 + 0.3 * hash01(f.seed, 3);
  const double in = ramp(0.05, 0.10, frame) * ramp(0.01, 0.045, std::abs(uv.y + ragged - split));
  return brushed(glm::mix(colorOf(f, 0), colorOf(f, uv.y > split ? 1 : 2), in), f.seed, uv);
}

/// A carpet: border, field of lozenges, medallion.
glm::dvec3 carpet(const PlanFinish& f, const glm::dvec2& uv) {
  const glm::dvec2 q = 0.5 - glm::abs(uv - 0.5);
  const double edge = std::min(q.x, 0.67 * q.y);
  const double weave = 0.08 * noise2(f.seed, uv * 150.0);
  if (edge < 0.012) return colorOf(f, 2) * (0.8 + weave);
  if (edge < 0.10) {
    const double run = q.x < 0.67 * q.y ? 30 * uv.y : 45 * uv.x;
    const double figure = std::cos(kTau * run / 3) * std::cos(kTau * (edge - 0.055) / 0.06);
    return glm::mix(colorOf(f, 1), colorOf(f, 2), ramp(0.15, 0.3, figure)) * (1 + weave);
  }
  if (edge < 0.115) return colorOf(f, 2) * (1 + weave);
  const glm::dvec2 c = glm::abs(uv - 0.5) * glm::dvec2(1.5, 1);
  const double medallion = c.x + c.y + 0.03 * std::cos(10 * std::atan2(c.y, c.x));
  if (medallion < 0.26) {
    const double bands = std::cos(kTau * medallion * 14);
    return glm::mix(colorOf(f, 1), colorOf(f, 2), ramp(0, 0.3, bands)) * (1 + weave);
  }
  const double lozenge =
      std::cos(kTau * 12 * (uv.x + uv.y * 0.67)) * std::cos(kTau * 12 * (uv.x - uv.y * 0.67));
  return glm::mix(colorOf(f, 0), colorOf(f, 2), 0.8 * ramp(0.55, 0.7, lozenge)) * (1 + weave);
}

}  // namespace

std::vector<PatternKind> picturePatterns() {
  return {
      {"landscape", 256, 192, landscape}, {"seascape", 256, 192, seascape},
      {"portrait", 192, 256, portrait},   {"still-life", 256, 192, stillLife},
      {"blocks", 256, 256, blocks},       {"circles", 256, 192, circles},
      {"fields", 192, 256, fields},       {"carpet", 384, 256, carpet},
  };
}

}  // namespace enfilade
