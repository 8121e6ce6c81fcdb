#include "preprocess/section.h"

#include <algorithm>
#include <array>

namespace enfilade {

namespace {

bool isFree(const VoxelGrid& voxels, const glm::vec3& p) {
  const glm::ivec3 v = voxels.voxelOf(p);
  return !voxels.contains(v) || !(voxels.bits[voxels.index(v.x, v.y, v.z)] & kVoxelSolid);
}

glm::ivec2 pixelOf(const SectionWindow& window, const glm::vec3& p) {
  const glm::vec3 local = glm::transpose(window.axes) * (p - window.center);
  return glm::ivec2(glm::floor((glm::vec2(local) - window.lo) / window.pixel));
}

}  // namespace

Section sectionAt(const VoxelGrid& voxels, const SectionWindow& window,
                  const std::vector<glm::vec3>& seeds, float n) {
  Section section;
  section.first = {window.size_u, window.size_v};
  section.inside.assign(
      static_cast<std::size_t>(window.size_u) * static_cast<std::size_t>(window.size_v), 0);
  std::vector<glm::ivec2> stack;
  const auto visit = [&](const glm::ivec2& p) {
    if (p.x < 0 || p.y < 0 || p.x >= window.size_u || p.y >= window.size_v) return;
    auto& inside = section.inside[std::size_t(p.x) * std::size_t(window.size_v) + std::size_t(p.y)];
    if (inside || !isFree(voxels, window.pointAt(p.x, p.y, n))) return;
    inside = 1;
    stack.push_back(p);
  };
  for (const glm::vec3& seed : seeds) visit(pixelOf(window, seed));
  while (!stack.empty()) {
    const glm::ivec2 p = stack.back();
    stack.pop_back();
    ++section.count;
    section.first = glm::min(section.first, p);
    section.end = glm::max(section.end, p + 1);
    section.open |= p.x == 0 || (p.y == 0 && !window.footed) || p.x + 1 == window.size_u ||
                    p.y + 1 == window.size_v;
    for (const glm::ivec2 side : {glm::ivec2(-1, 0), {1, 0}, {0, -1}, {0, 1}}) visit(p + side);
  }
  return section;
}

}  // namespace enfilade
