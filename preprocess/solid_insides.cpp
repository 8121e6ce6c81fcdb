#include "preprocess/solid_insides.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "preprocess/cell_merging.h"
#include "preprocess/random_sphere.h"
#include "render/ray_caster.h"

namespace enfilade {

namespace {

constexpr std::size_t kRays = 192;       // a cell
constexpr float kFarthest = 100.0f;      // [m]
constexpr float kMostlyBacks = 0.8f;     // of what rays meet: in a solid, closed or not
constexpr float kSomeBacks = 0.3f;       // in a solid whose faces coincide with others' fronts
constexpr std::size_t kPoints = 5;       // where the winding number is taken
constexpr double kMostOfBuilding = 0.4;  // of the cells' volume

/// Every voxel of the cells that are asked for, in the grid's order.
std::vector<std::vector<std::size_t>> voxelsOf(const std::vector<std::uint8_t>& asked,
                                               const std::vector<std::uint16_t>& owner) {
  std::vector<std::vector<std::size_t>> voxels(asked.size());
  for (std::size_t i = 0; i < owner.size(); ++i) {
    if (owner[i] < asked.size() && asked[owner[i]]) voxels[owner[i]].push_back(i);
  }
  return voxels;
}

/// The share of backs among what rays from the voxels meet; 0 if most meet nothing.
float shareOfBacks(const RayCaster& rays, const VoxelGrid& grid,
                   const std::vector<std::size_t>& voxels) {
  if (voxels.empty()) return 0;
  std::mt19937 random(static_cast<unsigned>(voxels.front()));
  std::vector<SurfaceOnRay> surfaces;
  std::size_t backs = 0, met = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    PictureRay ray;
    ray.origin = grid.centerOf(grid.voxelAt(voxels[i * voxels.size() / kRays]));
    ray.direction = randomDirection(random);
    ray.most = kFarthest;
    surfaces.clear();
    rays.surfacesOn(ray, surfaces);
    if (surfaces.empty()) continue;
    ++met;
    backs += glm::dot(surfaces.front().normal, ray.direction) > 0;
  }
  return 2 * met > kRays ? float(backs) / float(met) : 0.0f;
}

/// The solid angle of a triangle as seen from the origin, positive if its back is seen.
/// Source: Van Oosterom & Strackee, The Solid Angle of a Plane Triangle, 1983.
double solidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double triple = glm::dot(a, glm::cross(b, c));
  return 2 * std::atan2(triple, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                    glm::dot(c, a) * lb);
}

/// How often the building's surfaces wind about `p`: 1 inside a closed solid, 0 outside all.
double windingNumber(const Building& building, std::span<const ObjectRole> roles,
                     const glm::dvec3& p) {
  double angle = 0;
  for (std::size_t o = 0; o < building.objects.size(); ++o) {
    if (roles[o] != ObjectRole::kFixed) continue;
    const Mesh& mesh = building.meshOf(building.objects[o]);
    const glm::dmat4 world(building.worldFromObject(building.objects[o]));
    const double turn = isMirrored(glm::mat4(world)) ? -1 : 1;
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    const auto corner = [&](std::size_t i) {
      return glm::dvec3(world * glm::dvec4(positions[mesh.indices[i]], 1)) - p;
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      angle += turn * solidAngle(corner(i), corner(i + 1), corner(i + 2));
    }
  }
  return angle / (4 * std::numbers::pi);
}

/// Whether the surfaces wind about the voxels.
bool areEnclosed(const Building& building, std::span<const ObjectRole> roles, const VoxelGrid& grid,
                 const std::vector<std::size_t>& voxels) {
  double winding = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const std::size_t voxel = voxels[(2 * i + 1) * voxels.size() / (2 * kPoints)];
    winding += windingNumber(building, roles, glm::dvec3(grid.centerOf(grid.voxelAt(voxel))));
  }
  return winding > 0.5 * double(kPoints);
}

}  // namespace

std::vector<std::uint8_t> insidesOfSolids(const Building& building,
                                          std::span<const ObjectRole> roles,
                                          const VoxelGrid& voxels,
                                          const std::vector<std::uint16_t>& owner,
                                          std::size_t cells,
                                          const std::vector<Interface>& interfaces) {
  const std::vector<std::uint16_t> group = joinedCells(cells, interfaces);
  std::vector<std::uint8_t> inside(cells, 0);
  for (std::size_t c = 0; c < cells; ++c) inside[c] = group[c] != group[0];
  if (std::find(inside.begin(), inside.end(), 1) == inside.end()) return inside;
  const auto own = voxelsOf(inside, owner);
  const RayCaster rays(building, doorFlags(roles), 0);
  std::size_t volume = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const float backs = inside[c] ? shareOfBacks(rays, voxels, own[c]) : 0.0f;
    inside[c] = backs > kMostlyBacks ||
                (backs > kSomeBacks && areEnclosed(building, roles, voxels, own[c]));
    if (inside[c]) volume += own[c].size();
  }
  const auto all = std::count_if(owner.begin(), owner.end(), [](std::uint16_t cell) {
    return cell != kExterior && cell != CellProposal::kNobody;
  });
  if (double(volume) > kMostOfBuilding * double(all)) inside.assign(cells, 0);
  return inside;
}

}  // namespace enfilade
