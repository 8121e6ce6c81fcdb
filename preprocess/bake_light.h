#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "portals/cell_graph.h"
#include "preprocess/light_parameters.h"
#include "preprocess/progress.h"
#include "scene/building.h"

namespace enfilade {

/// What baking light did.
struct BakedLight {
  std::size_t points = 0, rays = 0, links = 0;
  float exposure = 0;  ///< [1/lx] 0: no light reached anything, and no colour was changed
};

/// Splits what is too large to carry light, works out how sky and lamps light every vertex, with
/// diffuse reflections, and multiplies it into the vertex colours; the materials become unlit.
/// What was unlit stays as it is.  Every object gets a mesh of its own, in the same order.  Light
/// passes the objects for which `clear` is 1 (doors that will stand open, windows); it may be
/// empty.  Without sky portals the sky shines in wherever a ray finds a way.  The same for any
/// number of threads.
/// Source: Cohen & Greenberg, The Hemi-Cube, 1985, for radiosity; see gatherLight().
BakedLight bakeLight(Building& building, std::span<const SkyPortal> portals,
                     std::span<const std::uint8_t> clear, const LightParameters& parameters,
                     const ProgressSink& progress = {});

/// The same for a building whose author named its rooms and portals: portals to the exterior are
/// the sky portals, and the markers stay as they are.
BakedLight bakeNamedLight(Building& building, const LightParameters& parameters,
                          const ProgressSink& progress = {});

/// The portals of `graph` between a room and the exterior.
std::vector<SkyPortal> skyPortals(const CellGraph& graph);

/// The stage that `progress` is told.
inline constexpr const char* kLightStage = "bake the light";

}  // namespace enfilade
