#pragma once

#include <nlohmann/json.hpp>

#include "app/comparison.h"

namespace enfilade {

/// What comparisonJson() writes, as an object.
nlohmann::ordered_json comparisonObject(const Comparison& comparison);

}  // namespace enfilade
