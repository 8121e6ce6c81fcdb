#include "scene/gltf_lights.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace enfilade {
namespace {

constexpr double kBrightest = 1e9;  // [cd] or [lx]: so that sums stay finite
constexpr double kFarthest = 1e9;   // [m]

/// `value` within its limits; `otherwise` if it is no number.
float within(double value, double least, double most, double otherwise) {
  return static_cast<float>(std::isfinite(value) ? std::clamp(value, least, most) : otherwise);
}

glm::vec3 colorOf(const std::vector<double>& numbers) {
  if (numbers.size() != 3) return glm::vec3(1);
  return {within(numbers[0], 0, 1e3, 1), within(numbers[1], 0, 1e3, 1),
          within(numbers[2], 0, 1e3, 1)};
}

/// False if its kind is unknown.
bool readLight(const tinygltf::Light& source, Light& light) {
  if (source.type == "directional") {
    light.kind = LightKind::kDirectional;
  } else if (source.type == "spot") {
    light.kind = LightKind::kSpot;
  } else if (source.type != "point") {
    return false;
  }
  light.name = source.name;
  light.color = colorOf(source.color);
  light.intensity = within(source.intensity, 0, kBrightest, 1);
  light.range = within(source.range, 0, kFarthest, 0);
  if (light.kind != LightKind::kSpot) return true;
  light.outer_angle =
      within(source.spot.outerConeAngle, 1e-3, glm::half_pi<double>(), glm::quarter_pi<double>());
  light.inner_angle = std::min(within(source.spot.innerConeAngle, 0, glm::half_pi<double>(), 0),
                               light.outer_angle * 0.999f);
  return true;
}

/// The light of a node, -1 for none.
int lightOf(const GltfModel& gltf, int gltf_node) {
  const tinygltf::Node& node = gltf->nodes[static_cast<std::size_t>(gltf_node)];
  const auto found = node.extensions.find("KHR_lights_punctual");
  if (found == node.extensions.end() || !found->second.IsObject()) return -1;
  const tinygltf::Value& light = found->second.Get("light");
  if (light.IsInt() && light.GetNumberAsInt() >= 0 &&
      static_cast<std::size_t>(light.GetNumberAsInt()) < gltf->lights.size()) {
    return light.GetNumberAsInt();
  }
  gltf.fail(fmt::format("is no valid glTF: node {} '{}' has a light that is not there", gltf_node,
                        oneLine(node.name)));
}

}  // namespace

void readLights(const GltfModel& gltf, const std::vector<int>& gltf_nodes, Building& building,
                WarningLog& warnings) {
  for (std::size_t n = 0; n < gltf_nodes.size(); ++n) {
    const int index = lightOf(gltf, gltf_nodes[n]);
    if (index < 0) continue;
    const tinygltf::Light& source = gltf->lights[static_cast<std::size_t>(index)];
    Light light;
    light.node = static_cast<std::uint32_t>(n);
    if (readLight(source, light)) {
      building.lights.push_back(std::move(light));
    } else {
      warnings.add("light of unknown kind \"" + oneLine(source.type, 40) + "\", left out",
                   "light '" + oneLine(source.name) + "'");
    }
  }
}

}  // namespace enfilade
