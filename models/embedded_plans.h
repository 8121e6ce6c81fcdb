#pragma once

#include <span>

namespace enfilade {

/// A floor plan from models/plans that was compiled into the program.
struct EmbeddedPlan {
  const char* name;  ///< the file's, without .json
  const char* text;
};

std::span<const EmbeddedPlan> embeddedPlans();

}  // namespace enfilade
