#include "plain_warp.h"

#include <cmath>

#include "ibr/sheets.h"
#include "ibr/warp_window.h"
#include "random_cameras.h"

namespace enfilade::testing {
namespace {

using R = FootprintRules;

struct Footprint {
  glm::dvec3 at;    ///< pixel and disparity
  glm::dvec2 half;  ///< [pixels]
};

Footprint footprintOf(const Ldi& ldi, const LdiTile& tile, const LdiSample& sample,
                      const PlanarCamera& desired) {
  const glm::dvec3 place = storedPlace(tile, sample);
  const auto at = [&](double du, double dv) {
    return projectPoint(desired, unprojectPoint(ldi.camera, place + glm::dvec3(du, dv, 0)));
  };
  const double e = 1e-4;
  const glm::dvec2 per_u = glm::abs(glm::dvec2(at(e, 0) - at(-e, 0))) / (2 * e);
  const glm::dvec2 per_v = glm::abs(glm::dvec2(at(0, e) - at(0, -e))) / (2 * e);
  const glm::dvec2 half =
      0.5 * (per_u * static_cast<double>(footprintSize(sample.footprint >> 4)) +
             per_v * static_cast<double>(footprintSize(sample.footprint & 15u)));
  return {at(0, 0),
          glm::clamp(half * static_cast<double>(R::kScale), static_cast<double>(R::kLeastHalf),
                     static_cast<double>(R::kGreatestHalf))};
}

/// Half the sides of the box of pixel centres that a splat of fixed size paints.
double halfSide(Splat splat) {
  return splat == Splat::k1x1 ? 0.5 : splat == Splat::k2x2 ? 1.0 : 1.5;
}

/// What the paper's splats do: a sample hides what was painted before it.
void paint(PlainPixel& a, const glm::dvec3& color) { a = {color, true, true, 0, 0}; }

/// A depth a pixel: the nearest surface counts.
void layOn(PlainPixel& a, const glm::dvec3& color, double disparity, double weight, Splat splat) {
  const auto same = static_cast<double>(R::kSameSurface);
  if (disparity * same < a.nearest) return;
  if (disparity > a.nearest * same) a = {glm::dvec3(0), true, true, disparity, 0};
  if (splat == Splat::kMean) {
    a.color += weight * color;
    a.weight += weight;
  } else if (weight > a.weight) {
    a.color = weight * color;
    a.weight = weight;
  }
}

void add(const Footprint& f, const LdiSample& sample, const PlanarCamera& desired,
         const std::vector<bool>& region, Splat splat, std::vector<PlainPixel>& pixels) {
  const glm::dvec3 color(sample.r, sample.g, sample.b);
  for (int y = 0; y < desired.height; ++y) {
    for (int x = 0; x < desired.width; ++x) {
      const auto p = static_cast<std::size_t>(y * desired.width + x);
      if (!region[p]) continue;
      const glm::dvec2 apart = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(f.at);
      const glm::dvec2 off = glm::abs(apart) / f.half;
      if (splat < Splat::kSized) {
        const double half = halfSide(splat);
        const bool in_box =
            apart.x > -half && apart.x <= half && apart.y > -half && apart.y <= half;
        const bool in_cross = std::min(std::abs(apart.x), std::abs(apart.y)) <= 0.5;
        if (in_box && (splat != Splat::kCross || in_cross)) paint(pixels[p], color);
      } else if (off.x < 1 && off.y < 1) {
        const double weight = splat == Splat::kMean ? 1.0 : (1 - off.x) * (1 - off.y);
        if (splat == Splat::kSized) {
          paint(pixels[p], color);
        } else {
          layOn(pixels[p], color, f.at.z, weight, splat);
        }
      }
    }
  }
}

/// The mean colour of a and b where they show one surface nearer than `behind`.
bool bridge(const PlainPixel& a, const PlainPixel& b, double behind, glm::dvec3& sum) {
  const auto ratio = static_cast<double>(R::kCrackDepth);
  if (std::min(a.nearest, b.nearest) <= behind * ratio ||
      std::max(a.nearest, b.nearest) >= std::min(a.nearest, b.nearest) * ratio) {
    return false;
  }
  sum += a.color / a.weight + b.color / b.weight;
  return true;
}

/// Closes cracks and divides by the weights.
std::vector<PlainPixel> resolve(const std::vector<PlainPixel>& pixels, std::size_t width,
                                const std::vector<bool>& region) {
  std::vector<PlainPixel> picture(region.size());
  for (std::size_t p = 0; p < region.size(); ++p) {
    if (!region[p]) continue;
    const PlainPixel& a = pixels[p];
    glm::dvec3 sum(0);
    int bridges = 0;
    for (const std::size_t step : {std::size_t{1}, width}) {
      const bool inside = p >= step && p + step < region.size() && region[p - step] &&
                          region[p + step] &&
                          (step > 1 || (p % width > 0 && p % width + 1 < width));
      bridges += inside && bridge(pixels[p - step], pixels[p + step], a.nearest, sum);
    }
    picture[p].covered = a.weight > 0;
    picture[p].shown = picture[p].covered || bridges > 0;
    if (bridges > 0) {
      picture[p].color = sum / (2.0 * bridges);
    } else if (a.weight > 0) {
      picture[p].color = a.color / a.weight;
    }
  }
  return picture;
}

}  // namespace

std::vector<PlainPixel> warpPlainly(const Ldi& ldi, const PlanarCamera& desired,
                                    const std::vector<bool>& region, Splat splat) {
  std::vector<PlainPixel> pixels(region.size());
  visitInSheets(ldi, sheetOrder(ldi.camera, desired.center), [&](const LdiTile& tile) {
    for (const LdiSample& s : std::span(ldi.samples).subspan(tile.first, tile.count)) {
      const Footprint f = footprintOf(ldi, tile, s, desired);
      if (f.at.z > 0) add(f, s, desired, region, splat, pixels);
    }
  });
  if (!keepsDepth(splat)) return pixels;
  return resolve(pixels, static_cast<std::size_t>(desired.width), region);
}

}  // namespace enfilade::testing
