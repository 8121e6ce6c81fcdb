#pragma once

#include <vector>

#include "models/mesh_builder.h"
#include "models/plan_layout.h"

namespace enfilade {

/// A profile that runs along the walls: points (out from the wall, level) [m] from low to high.
using TrimProfile = std::vector<glm::dvec2>;

TrimProfile skirtingProfile(double floor);
TrimProfile corniceProfile(double ceiling);
TrimProfile facadeCorniceProfile(double level);
TrimProfile plinthProfile(double ground);

/// Runs a profile along the walls of an outline, mitred at the corners.  `skip`: openings, if any,
/// at whose jambs it stops.
enum class TrimGaps { kNowhere, kAtDoors };
void raiseTrim(const PlanStorey& plan, const Outline& outline, const Layout& layout,
               const TrimProfile& profile, TrimGaps gaps, MeshBuilder& mesh);

/// The architraves around the openings of an area: mouldings that stand on the wall's face.
void raiseArchitraves(const PlanStorey& plan, const Outline& outline, const Layout& layout,
                      MeshBuilder& mesh);

}  // namespace enfilade
