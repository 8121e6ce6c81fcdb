#include "preprocess/sight_claims.h"

#include <limits>

namespace enfilade {
namespace {

constexpr int kMostPanes = 8;  // blended surfaces that a ray passes before it is given up

}  // namespace

std::vector<CrackLine> cracksOf(std::span<const Sighted> parts) {
  std::vector<CrackLine> cracks;
  for (const Sighted& part : parts) {
    cracks.insert(cracks.end(), part.cracks.begin(), part.cracks.end());
  }
  return cracks;
}

void addClaims(std::span<const Sighted> parts, PatchCells& claims) {
  for (const Sighted& part : parts) {
    claims.claims.insert(claims.claims.end(), part.claims.begin(), part.claims.end());
  }
  claims.sortAndUnite();
}

CellGrid::Label SightClaims::label(const glm::ivec3& v) const noexcept {
  const glm::ivec3& size = grid_.size();
  if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, size))) {
    return static_cast<CellGrid::Label>(kExterior);
  }
  const auto column = static_cast<std::size_t>(v.x) * static_cast<std::size_t>(size.z) +
                      static_cast<std::size_t>(v.z);
  return labels_[column * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(v.y)];
}

/// Surfaces stand on the border of free space: a voxel about `p` that is the cell's, or that a
/// portal cuts, will do.
bool SightClaims::liesBeside(const glm::vec3& p, CellId cell) const noexcept {
  const glm::ivec3 v = grid_.voxelOf(p);
  for (int x = v.x - 1; x <= v.x + 1; ++x) {
    for (int z = v.z - 1; z <= v.z + 1; ++z) {
      for (int y = v.y - 1; y <= v.y + 1; ++y) {
        const CellGrid::Label there = label({x, y, z});
        if (there == cell || there == CellGrid::kCutVoxel) return true;
      }
    }
  }
  return false;
}

CrackLine SightClaims::crackLine(const PatchCells::Claim& claim, const glm::vec3& start,
                                 const glm::vec3& end) const noexcept {
  const float length = glm::distance(start, end);
  CrackLine line{claim, start, end, 0, length};
  const glm::vec3 direction = (end - start) / length;
  const float step = 0.5f * grid_.voxel();
  bool inside = true;
  for (float t = step; t < length; t += step) {
    const CellGrid::Label there = labelAt(start + direction * t);
    if (there == claim.cell || there == CellGrid::kCutVoxel) {
      line.solid_from = t;
      line.solid_to = length;
      inside = true;
    } else if (there != CellGrid::kSolidVoxel && inside) {
      line.solid_to = t;
      inside = false;
    }
  }
  return line;
}

void SightClaims::follow(CellId start, const glm::vec3& origin, const glm::vec3& direction,
                         Sighted& out) const {
  float passed = 0;
  for (int pane = 0; pane < kMostPanes; ++pane) {
    const RayHit hit =
        rays_.cast(origin, direction, passed, std::numeric_limits<float>::infinity(), false);
    if (hit.distance < 0) return;
    const CellId cell = walker_.walk(start, origin, direction, hit.distance, out.crossings);
    if (cell != kNoCell) {
      const PatchCells::Claim claim{patches_.patch_of_triangle[hit.object][hit.triangle], cell};
      out.claims.push_back(claim);
      const glm::vec3 end = origin + direction * hit.distance;
      const float from =
          out.crossings.empty() ? 0.0f : std::max(0.0f, out.crossings.back().distance);
      if (from < hit.distance && !liesBeside(end, cell)) {
        out.cracks.push_back(crackLine(claim, origin + direction * from, end));
      }
    }
    if (building_.materialOf(building_.objects[hit.object]).alpha_mode != AlphaMode::kBlend) return;
    passed = hit.distance + 1e-4f * (1.0f + hit.distance);
  }
}

}  // namespace enfilade
