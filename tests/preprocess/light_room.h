#pragma once

#include <vector>

#include "preprocess/light_bounces.h"
#include "preprocess/light_gather.h"
#include "preprocess/light_points.h"
#include "preprocess/light_sides.h"
#include "render/light_rays.h"
#include "scene/tessellate.h"

namespace enfilade {

/// Parts of a room for tests of light: single-sided rectangles of one grey.
class LightRoom {
 public:
  explicit LightRoom(float albedo) {
    building.name = "room";
    Material material;
    material.base_color = glm::vec4(glm::vec3(albedo), 1);
    building.materials.push_back(material);
  }

  /// A rectangle seen from where a → b → d turns counter-clockwise.
  void face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& d) {
    const auto n = static_cast<std::uint32_t>(building.objects.size());
    VertexArrays vertices;
    vertices.positions = {a, b, b + d - a, d};
    vertices.normals.assign(4, glm::normalize(glm::cross(b - a, d - a)));
    building.vertex_arrays.push_back(vertices);
    Mesh mesh{"face", n, 0, {0, 1, 2, 0, 2, 3}, {}};
    for (const glm::vec3& p : vertices.positions) mesh.bounds.extend(p);
    building.meshes.push_back(mesh);
    building.nodes.push_back({"face", kNone, glm::mat4(1), {}});
    building.objects.push_back({n, n});
  }

  /// A closed box from the origin to `s`, seen from inside.
  void box(const glm::vec3& s) {
    face({0, 0, 0}, {0, 0, s.z}, {s.x, 0, 0});
    face({0, s.y, 0}, {s.x, s.y, 0}, {0, s.y, s.z});
    face({0, 0, 0}, {0, s.y, 0}, {0, 0, s.z});
    face({s.x, 0, 0}, {s.x, 0, s.z}, {s.x, s.y, 0});
    face({0, 0, 0}, {s.x, 0, 0}, {0, s.y, 0});
    face({0, 0, s.z}, {0, s.y, s.z}, {s.x, 0, s.z});
  }

  void lamp(const glm::vec3& at, float candela) {
    Light light;
    light.node = static_cast<std::uint32_t>(building.nodes.size());
    light.intensity = candela;
    glm::mat4 place(1);
    place[3] = glm::vec4(at, 1);
    building.nodes.push_back({"lamp", kNone, place, {}});
    building.lights.push_back(light);
  }

  Building building;
};

/// Illuminance at every point [lx], as bakeLight works it out before it is toned.
struct RoomLight {
  LightPoints points;
  std::vector<glm::vec3> light;
};

inline RoomLight lightOf(Building building, const std::vector<SkyPortal>& portals,
                         const LightParameters& parameters) {
  if (parameters.longest_edge > 0) splitLongEdges(building, parameters.longest_edge);
  std::vector<OneWayScreen> screens;
  for (const SkyPortal& portal : portals) screens.push_back({portal.polygon, portal.inward});
  const LightRays rays(building, {}, screens);
  const WorldGeometry& world = rays.surfaces().world();
  RoomLight result{makeLightPoints(building, world), {}};
  const LightSides sides = chooseSides(building, result.points, rays, parameters.threads);
  const GatheredLight gathered =
      gatherLight(building, result.points, sides, rays, portals, parameters, {});
  result.light =
      bounceLight(result.points, world, gathered, parameters.bounces, parameters.threads);
  return result;
}

inline SkyLight evenSky(float luminance) {
  return {glm::vec3(luminance), glm::vec3(luminance), glm::vec3(luminance)};
}

}  // namespace enfilade
