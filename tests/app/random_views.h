#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <random>

#include "portals/house.h"
#include "scene/camera.h"

namespace enfilade::testing {

/// Where an eye stands: the places at which culling goes wrong if it does.
enum class EyePlace : std::uint8_t {
  kFreeSpace,
  kBesideSurface,  ///< free, with something solid in the next voxel
  kSolid,
  kPortal,        ///< on its polygon
  kPortalEdge,    ///< on an edge of it
  kPortalCorner,  ///< on a corner
  kPortalPlane,   ///< on its plane, a metre or so beside it, in free space or not
  kAnywhere,      ///< in the building's box or outside it, far away now and then
};
inline constexpr int kEyePlaces = 8;

/// "free space", "portal edge", …
const char* nameOf(EyePlace place);

struct RandomView {
  EyePlace place = EyePlace::kFreeSpace;
  Camera camera;
};

/// Views of a house from places of each kind, upright or turned any way, 1° to 170° high.  The same
/// ones for the same seed.
class RandomViews {
 public:
  /// The house has a portal.
  RandomViews(const House& house, unsigned seed);

  /// `place` at random, or the one asked for.
  RandomView next(float aspect);
  RandomView next(EyePlace place, float aspect);

 private:
  glm::vec3 eyeAt(EyePlace place);
  glm::vec3 onPortal(EyePlace place);
  glm::vec3 inVoxelThat(bool (*fits)(const CellGrid&, const glm::ivec3&));
  glm::quat rotation();
  float uniform(float least, float most);

  const House& house_;
  const Box bounds_;
  const float far_plane_;
  std::mt19937 random_;
};

}  // namespace enfilade::testing
