#include "models/moulded_block.h"

namespace enfilade {

void raiseMouldedBlock(const glm::dvec2& half, const std::vector<MouldingPoint>& profile,
                       double texture_size, MeshBuilder& mesh) {
  // Corners k = 0…3 go around as seen from above, from (−x, +z) by (+x, +z).
  const auto at = [&](int k, const MouldingPoint& p) {
    return glm::dvec3((k == 0 || k == 3 ? -1 : 1) * (half.x + p.out), p.y,
                      (k < 2 ? 1 : -1) * (half.y + p.out));
  };
  for (int k = 0; k < 4; ++k) {
    const auto corner = [&](int which, const MouldingPoint& p) {
      const glm::dvec3 position = at(which % 4, p);
      const double along = k % 2 == 0 ? position.x : position.z;
      return Corner{position, glm::dvec2(along, -p.y) / texture_size, p.shade};
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
      mesh.flatQuad(corner(k, profile[i]), corner(k + 1, profile[i]), corner(k + 1, profile[i + 1]),
                    corner(k, profile[i + 1]));
  }
  const auto top = [&](int k) {
    const glm::dvec3 position = at(k, profile.back());
    return Corner{position, glm::dvec2(position.x, position.z) / texture_size,
                  profile.back().shade};
  };
  mesh.flatQuad(top(0), top(1), top(2), top(3));
}

}  // namespace enfilade
