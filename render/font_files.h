#pragma once

#include <string_view>

namespace enfilade {

/// TrueType files that the program carries with it: DejaVu Sans.
extern const std::string_view kRegularFont;
extern const std::string_view kBoldFont;

}  // namespace enfilade
