#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/furniture_library.h"
#include "scene/building.h"

namespace enfilade {

/// Names of the built-in buildings.
std::vector<std::string> sampleNames();

/// Raises a built-in building from its floor plan, or that of a plan's file (NAME.json); about
/// `triangles` of them (50,000…10,000,000; 0: the sample's own number). Carries the true cells and
/// portals by name (NAME-room, NAME-portal). The same bytes run after run. Throws Error (kUsage)
/// for an unknown name, listing those there are; (kBadInput) for a plan that is wrong; (kMachine)
/// if it needs furniture catalogues that are not in `furniture_folder`.
/// `to_be_lit`: see raiseBuilding().
Building raiseSample(const std::string& name, std::uint64_t triangles = 0,
                     const std::string& furniture_folder = kFurnitureFolder,
                     bool to_be_lit = false);

/// Whether the plan asks for baked light.  Throws as raiseSample does.
bool wantsBakedLight(const std::string& name);

}  // namespace enfilade
