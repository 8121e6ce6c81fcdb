#pragma once

#include <nlohmann/json.hpp>

#include "app/report.h"

namespace enfilade {

/// summary.json as an object, its keys in the order in which DESIGN section 6 has them.
nlohmann::ordered_json summaryObject(const Report& report);

}  // namespace enfilade
