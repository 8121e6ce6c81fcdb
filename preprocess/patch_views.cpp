#include "preprocess/patch_views.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "preprocess/random_sphere.h"
#include "render/parallel_for.h"

namespace enfilade {
namespace {

constexpr std::size_t kPatchesPerBlock = 256;
constexpr float kLongest = 20;  ///< [voxels] that a line goes through what the voxels call solid

/// A triangle of an object.
struct PatchTriangle {
  std::uint32_t object, triangle;
};

/// The triangles of each patch, one patch after the other.
struct PatchTriangles {
  std::vector<std::uint32_t> first;  ///< patches + 1, into triangles
  std::vector<PatchTriangle> triangles;
};

PatchTriangles trianglesOf(const Patches& patches) {
  PatchTriangles out;
  out.first.assign(patches.count + 1, 0);
  for (const auto& object : patches.patch_of_triangle) {
    for (const std::uint32_t patch : object) ++out.first[patch + 1];
  }
  for (std::size_t p = 0; p < patches.count; ++p) out.first[p + 1] += out.first[p];
  out.triangles.resize(out.first.back());
  std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
  for (std::uint32_t o = 0; o < patches.patch_of_triangle.size(); ++o) {
    const auto& object = patches.patch_of_triangle[o];
    for (std::uint32_t t = 0; t < object.size(); ++t) {
      out.triangles[next[object[t]]++] = {o, t};
    }
  }
  return out;
}

class PatchViews {
 public:
  PatchViews(const Building& building, const RayCaster& rays, const SightClaims& sight)
      : building_(building), rays_(rays), sight_(sight), voxel_(sight.voxel()) {}

  /// One line to the triangle, or two if it leads from one cell into another.
  void look(const PatchTriangle& from, std::mt19937& random, Sighted& out) const {
    const glm::vec3 point = pointBeside(from, random);
    const glm::vec3 direction = randomDirection(random);
    const Exit there = exitAlong(point, direction);
    if (!there.is_cell) return;
    const Exit back = exitAlong(point, -direction);
    const bool leads_on = back.is_cell && back.label != there.label;
    if (!leads_on && there.from < 1.5f * voxel_) return;
    sight_.follow(there.label, point + direction * there.to, -direction, out);
    if (leads_on) sight_.follow(back.label, point - direction * back.to, direction, out);
  }

 private:
  /// Where a line comes out into free space [m].
  struct Exit {
    bool is_cell = false;  ///< of a cell, without meeting anything
    CellGrid::Label label = CellGrid::kSolidVoxel;
    float from = 0, to = 0;  ///< [from, to] lies in the cell
  };

  Exit exitAlong(const glm::vec3& point, const glm::vec3& direction) const {
    const float longest = kLongest * voxel_;
    const RayHit hit = rays_.cast(point, direction, 1e-4f, longest, false);
    const float free = hit.distance < 0 ? longest : hit.distance;
    const float step = 0.5f * voxel_;
    for (float t = 0; t < free; t += step) {
      const CellGrid::Label label = sight_.labelAt(point + direction * t);
      if (label == CellGrid::kSolidVoxel) continue;
      if (label == CellGrid::kCutVoxel) break;
      const float further = std::min(t + step, 0.5f * (t + free));
      const bool in_cell = sight_.labelAt(point + direction * further) == label;
      return {true, label, t, in_cell ? further : t};
    }
    return {};
  }

  /// A random point of the triangle, or up to a voxel before or behind it, mostly much less.
  glm::vec3 pointBeside(const PatchTriangle& at, std::mt19937& random) const {
    const Object& object = building_.objects[at.object];
    const Mesh& mesh = building_.meshOf(object);
    const auto& positions = building_.vertex_arrays[mesh.vertices].positions;
    const auto corner = [&](std::size_t k) {
      return glm::vec3(building_.worldFromObject(object) *
                       glm::vec4(positions[mesh.indices[3 * std::size_t{at.triangle} + k]], 1));
    };
    const glm::vec3 first = corner(0);
    const glm::vec3 u = corner(1) - first;
    const glm::vec3 v = corner(2) - first;
    const float along = randomUnit(random);
    const float across = randomUnit(random);
    const bool inside = along + across <= 1;
    const glm::vec3 point =
        first + (inside ? along : 1 - along) * u + (inside ? across : 1 - across) * v;
    const glm::vec3 normal = glm::cross(u, v);
    const float length = glm::length(normal);
    const float side = 4 * randomUnit(random) - 2;  // half of them on the triangle
    if (!(length > 0) || std::abs(side) < 1) return point;
    const float away = voxel_ * std::exp2(-7 * (std::abs(side) - 1));
    return point + (side > 0 ? away : -away) / length * normal;
  }

  const Building& building_;
  const RayCaster& rays_;
  const SightClaims& sight_;
  float voxel_;
};

}  // namespace

std::vector<CrackLine> lookFromPatches(const Building& building, const Patches& patches,
                                       const RayCaster& rays, const SightClaims& sight,
                                       std::size_t lines) {
  if (patches.count == 0) return {};
  const PatchTriangles all = trianglesOf(patches);
  const PatchViews views(building, rays, sight);
  const std::size_t each = std::clamp<std::size_t>(lines / patches.count, 4, 64);
  std::vector<Sighted> found((patches.count + kPatchesPerBlock - 1) / kPatchesPerBlock);
  parallelFor(found.size(), [&](std::size_t b) {
    std::mt19937 random(0x51f15eedu + static_cast<unsigned>(b));
    const std::size_t end = std::min<std::size_t>(patches.count, (b + 1) * kPatchesPerBlock);
    for (std::size_t p = b * kPatchesPerBlock; p < end; ++p) {
      const std::size_t triangles = all.first[p + 1] - all.first[p];
      for (std::size_t i = 0; i < each; ++i) {
        const PatchTriangle& from = all.triangles[all.first[p] + random() % triangles];
        views.look(from, random, found[b]);
      }
    }
  });
  return cracksOf(found);
}

}  // namespace enfilade
