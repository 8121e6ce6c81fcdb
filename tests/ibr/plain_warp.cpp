#include "plain_warp.h"

#include <cmath>

#include "ibr/reconstruction.h"
#include "ibr/sheets.h"
#include "random_cameras.h"

namespace enfilade::testing {
namespace {

using R = Reconstruction;

struct Accumulated {
  double nearest = 0;
  double weight = 0;
  glm::dvec3 color{0};
};

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
          glm::clamp(half * static_cast<double>(R::kFootprintScale),
                     static_cast<double>(R::kLeastHalf), static_cast<double>(R::kGreatestHalf))};
}

void add(const Footprint& f, const LdiSample& sample, const PlanarCamera& desired,
         const std::vector<bool>& region, std::vector<Accumulated>& pixels) {
  for (int y = 0; y < desired.height; ++y) {
    for (int x = 0; x < desired.width; ++x) {
      const glm::dvec2 off = glm::abs(glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(f.at)) / f.half;
      const auto p = static_cast<std::size_t>(y * desired.width + x);
      if (!region[p] || off.x >= 1 || off.y >= 1) {
        continue;
      }
      Accumulated& a = pixels[p];
      if (f.at.z * static_cast<double>(R::kSameSurface) < a.nearest) {
        continue;
      }
      if (f.at.z > a.nearest * static_cast<double>(R::kSameSurface)) {
        a = {f.at.z, 0, glm::dvec3(0)};
      }
      const double weight = (std::pow(1 - off.x, 2) + 1e-4) * (std::pow(1 - off.y, 2) + 1e-4);
      a.weight += weight;
      a.color += weight * glm::dvec3(sample.r, sample.g, sample.b);
    }
  }
}

/// The mean colour of a and b where they show one surface nearer than `behind`.
bool bridge(const Accumulated& a, const Accumulated& b, double behind, glm::dvec3& sum) {
  const auto ratio = static_cast<double>(R::kCrackDepth);
  if (std::min(a.nearest, b.nearest) <= behind * ratio ||
      std::max(a.nearest, b.nearest) >= std::min(a.nearest, b.nearest) * ratio) {
    return false;
  }
  sum += a.color / a.weight + b.color / b.weight;
  return true;
}

}  // namespace

std::vector<PlainPixel> warpPlainly(const Ldi& ldi, const PlanarCamera& desired,
                                    const std::vector<bool>& region) {
  std::vector<Accumulated> pixels(region.size());
  visitInSheets(ldi, sheetOrder(ldi.camera, desired.center), [&](const LdiTile& tile) {
    for (const LdiSample& s : std::span(ldi.samples).subspan(tile.first, tile.count)) {
      const Footprint f = footprintOf(ldi, tile, s, desired);
      if (f.at.z > 0) {
        add(f, s, desired, region, pixels);
      }
    }
  });

  std::vector<PlainPixel> picture(region.size());
  const auto width = static_cast<std::size_t>(desired.width);
  for (std::size_t p = 0; p < region.size(); ++p) {
    if (!region[p]) {
      continue;
    }
    const Accumulated& a = pixels[p];
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

}  // namespace enfilade::testing
