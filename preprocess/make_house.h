#pragma once

#include <optional>

#include "portals/given_graph.h"
#include "portals/house.h"
#include "preprocess/stages.h"

namespace enfilade {

/// Finds the cells and portals of `model`, lights it if that is asked for, and shares its geometry
/// out to the cells: a house without images that does not yet say where it comes from.  Takes the
/// cells of `given` if there is one.  The same house for any number of threads.
House makeHouse(Building model, const PreprocessParameters& parameters,
                const std::optional<GivenGraph>& given, const Stages& stages);

}  // namespace enfilade
