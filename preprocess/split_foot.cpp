#include "preprocess/split_foot.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kHighest = 0.4f;  // [m] of the foot above the interface's lowest face
constexpr float kUpright = 0.5f;  // |normal.y| at most

/// Whether a face is level: its centre lies on a plane between voxels.
bool isLevel(const VoxelGrid& voxels, const glm::vec3& face) {
  const float y = (face.y - voxels.origin.y) / voxels.voxel;
  return std::abs(y - std::round(y)) < 0.25f;
}

Interface partOf(const Interface& whole, std::vector<glm::vec3> faces, const glm::vec3& normal) {
  Interface part;
  part.low = whole.low;
  part.high = whole.high;
  glm::dvec3 centroid(0.0);
  for (const glm::vec3& face : faces) {
    part.bounds.extend(face);
    centroid += glm::dvec3(face) / static_cast<double>(faces.size());
  }
  part.faces = std::move(faces);
  part.centroid = glm::vec3(centroid);
  part.normal = normal;
  part.planarity = 1;
  return part;
}

}  // namespace

std::optional<std::pair<Interface, Interface>> splitFoot(const VoxelGrid& voxels,
                                                         const Interface& interface) {
  const glm::vec3& n = interface.normal;
  if (std::abs(n.y) > kUpright) return std::nullopt;
  const float highest = interface.bounds.min.y + kHighest;
  float foot = -std::numeric_limits<float>::infinity();
  for (const glm::vec3& face : interface.faces) {
    if (face.y <= highest && isLevel(voxels, face)) foot = std::max(foot, face.y);
  }
  std::vector<glm::vec3> above, level;
  for (const glm::vec3& face : interface.faces) (face.y > foot ? above : level).push_back(face);
  if (level.empty() || above.size() <= level.size()) return std::nullopt;
  Interface upright =
      partOf(interface, std::move(above), glm::normalize(glm::vec3(n.x, 0.0f, n.z)));
  upright.foot = foot;
  return std::pair(std::move(upright),
                   partOf(interface, std::move(level), {0.0f, n.y < 0 ? -1.0f : 1.0f, 0.0f}));
}

}  // namespace enfilade
