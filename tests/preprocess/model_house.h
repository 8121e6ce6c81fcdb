#pragma once

#include <string>

#include "portals/house.h"

namespace enfilade::testing {

/// The house of a model, without images; `doors` and `windows` are patterns of matchNames().
House houseOf(Building building, const std::string& doors, const std::string& windows);

}  // namespace enfilade::testing
