#include "preprocess/bake_light.h"

#include "preprocess/authored_names.h"
#include "preprocess/light_bounces.h"
#include "preprocess/light_colors.h"
#include "preprocess/light_gather.h"
#include "preprocess/light_points.h"
#include "preprocess/light_sides.h"
#include "preprocess/light_tone.h"
#include "render/light_rays.h"
#include "scene/tessellate.h"

namespace enfilade {

BakedLight bakeLight(Building& building, std::span<const SkyPortal> portals,
                     std::span<const std::uint8_t> clear, const LightParameters& parameters,
                     const ProgressSink& progress) {
  const auto tell = [&](double done) {
    if (progress) progress(kLightStage, done);
  };
  tell(0);
  if (parameters.longest_edge > 0) splitLongEdges(building, parameters.longest_edge);
  std::vector<OneWayScreen> screens;
  for (const SkyPortal& portal : portals) screens.push_back({portal.polygon, portal.inward});
  BakedLight baked;
  {
    const LightRays rays(building, clear, screens);
    const WorldGeometry& world = rays.surfaces().world();
    const LightPoints points = makeLightPoints(building, world);
    const LightSides sides = chooseSides(building, points, rays, parameters.threads);
    const GatheredLight gathered = gatherLight(building, points, sides, rays, portals, parameters,
                                               [&](double done) { tell(0.05 + 0.9 * done); });
    const std::vector<glm::vec3> light =
        bounceLight(points, world, gathered, parameters.bounces, parameters.threads);
    const LightTone tone = toneFor(points, gathered, light, parameters.mid_tone);
    baked = {points.size(), gathered.rays, gathered.links, tone.exposure};
    if (tone.exposure > 0) {
      building = colorByLight(building, world, points, light, tone, parameters.threads);
    }
  }
  tell(1);
  return baked;
}

BakedLight bakeNamedLight(Building& building, const LightParameters& parameters,
                          const ProgressSink& progress) {
  const std::vector<Object> all = building.objects;
  const AuthoredNames names = takeAuthoredNames(building);
  const std::vector<Object> drawn = building.objects;
  std::vector<SkyPortal> portals;
  for (const AuthoredNames::NamedPortal& named : names.portals) {
    // Wound as seen from the room that states it.
    if (named.to == "exterior") {
      portals.push_back({named.portal.polygon, planeOf(named.portal.polygon).normal});
    }
  }
  const BakedLight baked = bakeLight(building, portals, {}, parameters, progress);
  std::vector<Object> restored;
  std::size_t next = 0;
  for (const Object& object : all) {
    const bool is_drawn =
        next < drawn.size() && object.node == drawn[next].node && object.mesh == drawn[next].mesh;
    restored.push_back(is_drawn ? building.objects[next++] : object);
  }
  building.objects = std::move(restored);
  return baked;
}

std::vector<SkyPortal> skyPortals(const CellGraph& graph) {
  std::vector<SkyPortal> portals;
  for (const Portal& portal : graph.portals) {
    if (portal.back == kExterior && portal.front != kExterior) {
      portals.push_back({portal.polygon, portal.plane.normal});
    } else if (portal.front == kExterior && portal.back != kExterior) {
      portals.push_back({portal.polygon, -portal.plane.normal});
    }
  }
  return portals;
}

}  // namespace enfilade
