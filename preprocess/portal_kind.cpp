#include "preprocess/portal_kind.h"

#include <cmath>

namespace enfilade {

namespace {

constexpr float kFilledShare = 0.3f;  // of a portal's face with a door or glass in it
constexpr float kReach = 0.35f;       // [m] either way, where they may stand
constexpr float kSill = 0.3f;         // [m] the highest threshold of a door
constexpr float kLowestDoor = 1.5f;   // [m]
constexpr float kHighestDoor = 3.0f;  // [m]
constexpr float kWidestDoor = 3.0f;   // [m]
constexpr float kLintel = 0.15f;      // [m] the least drop of a lintel below the ceiling

std::uint8_t bitsAt(const VoxelGrid& voxels, const glm::vec3& p) {
  const glm::ivec3 v = voxels.voxelOf(p);
  return voxels.contains(v) ? voxels.bits[voxels.index(v.x, v.y, v.z)] : std::uint8_t{0};
}

/// The share of the portal's face behind which, within reach, some voxel has `bit`.
float filledShare(const VoxelGrid& voxels, const FittedPortal& portal, std::uint8_t bit) {
  const float step = voxels.voxel;
  int filled = 0, all = 0;
  for (float u = -portal.half.x + step / 2; u < portal.half.x; u += step) {
    for (float v = -portal.half.y + step / 2; v < portal.half.y; v += step) {
      ++all;
      for (float n = -kReach; n <= kReach; n += step / 2) {
        if (bitsAt(voxels, portal.center + portal.axes * glm::vec3(u, v, n)) & bit) {
          ++filled;
          break;
        }
      }
    }
  }
  return all > 0 ? float(filled) / float(all) : 0.0f;
}

/// How far one can go from `p` along `direction` before something solid, at most `most` [m].
float freeLength(const VoxelGrid& voxels, const glm::vec3& p, const glm::vec3& direction,
                 float most) {
  float length = 0;
  while (length < most && !(bitsAt(voxels, p + direction * length) & kVoxelSolid)) {
    length += voxels.voxel / 2;
  }
  return length;
}

/// Whether one side of the portal has its floor at the portal's foot, and a ceiling above its head.
bool isDoorway(const VoxelGrid& voxels, const FittedPortal& portal, float side) {
  constexpr float kAside = 0.6f;
  const glm::vec3 foot =
      portal.center - portal.axes[1] * (portal.half.y - 0.4f) + portal.axes[2] * (side * kAside);
  const glm::vec3 head =
      portal.center + portal.axes[1] * (portal.half.y - 0.2f) + portal.axes[2] * (side * kAside);
  const bool from_floor = freeLength(voxels, foot, {0, -1, 0}, 2.0f) <= 0.4f + kSill;
  const bool under_lintel = freeLength(voxels, head, {0, 1, 0}, 2.0f) >= 0.2f + kLintel;
  return from_floor && under_lintel;
}

}  // namespace

PortalKind kindOf(const VoxelGrid& voxels, const FittedPortal& portal, bool to_exterior) {
  const bool level = std::abs(portal.axes[2].y) > 0.5f;
  if (!level && filledShare(voxels, portal, kVoxelDoor) > kFilledShare) return PortalKind::kDoor;
  if (filledShare(voxels, portal, kVoxelGlass) > kFilledShare) return PortalKind::kWindow;
  if (level) return PortalKind::kOpening;
  const bool sized = 2 * portal.half.y <= kHighestDoor && 2 * portal.half.y >= kLowestDoor &&
                     2 * portal.half.x <= kWidestDoor;
  // The exterior may have no ground, and a gallery's door may open on a void.
  if (sized &&
      (isDoorway(voxels, portal, -1.0f) || (!to_exterior && isDoorway(voxels, portal, 1.0f)))) {
    return PortalKind::kDoor;
  }
  const glm::vec3 foot =
      portal.center - portal.axes[1] * (portal.half.y - 0.2f) - portal.axes[2] * 0.6f;
  if (to_exterior && freeLength(voxels, foot, {0, -1, 0}, 2.0f) > 0.2f + kSill) {
    return PortalKind::kWindow;
  }
  return PortalKind::kOpening;
}

}  // namespace enfilade
