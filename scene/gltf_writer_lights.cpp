#include <nlohmann/json.hpp>

#include "scene/gltf_writer_parts.h"

namespace enfilade {
namespace {

using nlohmann::ordered_json;

ordered_json encodeLight(const Light& light) {
  constexpr const char* kKinds[] = {"point", "spot", "directional"};
  ordered_json json;
  if (!light.name.empty()) json["name"] = light.name;
  json["type"] = kKinds[static_cast<int>(light.kind)];
  json["color"] = {light.color.r, light.color.g, light.color.b};
  json["intensity"] = light.intensity;
  if (light.range > 0) json["range"] = light.range;
  if (light.kind == LightKind::kSpot) {
    json["spot"] = {{"innerConeAngle", light.inner_angle}, {"outerConeAngle", light.outer_angle}};
  }
  return json;
}

}  // namespace

void writeLights(const Building& building, ordered_json& root) {
  if (building.lights.empty()) return;
  ordered_json lights = ordered_json::array();
  for (const Light& light : building.lights) {
    root["nodes"][light.node]["extensions"]["KHR_lights_punctual"] = {{"light", lights.size()}};
    lights.push_back(encodeLight(light));
  }
  root["extensions"]["KHR_lights_punctual"] = {{"lights", std::move(lights)}};
  root["extensionsUsed"].push_back("KHR_lights_punctual");
}

}  // namespace enfilade
