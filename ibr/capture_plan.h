#pragma once

#include <string>
#include <vector>

#include "ibr/image_parameters.h"

namespace enfilade {

/// Reads a plan of captures: rings joined by commas, each `ring:COUNT`, then perhaps `@HEIGHT`
/// above the eye [m] and `/ANGLE` of the outermost viewpoint from the portal's normal [degrees], in
/// that order: "ring:13" or "ring:13,ring:6@-0.5/62.5".  Throws Error (kUsage) that says what is
/// wrong and how to write it.
std::vector<CaptureRing> parseCapturePlan(const std::string& text);

/// The plan as parseCapturePlan() reads it; what is as usual is left out.
std::string capturePlanText(const std::vector<CaptureRing>& rings);

}  // namespace enfilade
