#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "preprocess/light_gather.h"

namespace enfilade {

/// Points that stand in walls or under furniture, where no light comes: they have the mean of their
/// neighbours' along the faces, so that no darkness creeps out from there.
class HiddenPoints {
 public:
  HiddenPoints(const LightPoints& points, const WorldGeometry& world, const GatheredLight& light);

  /// Gives hidden points their neighbours' mean.
  void fill(std::vector<glm::vec3>& light) const;

 private:
  struct Filled {
    std::uint32_t point, neighbours_end;
  };
  std::vector<Filled> filled_;  // those nearer to what is not hidden first
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace enfilade
