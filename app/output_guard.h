#pragma once

#include <string>

namespace enfilade {

/// Throws Error (kUsage) if the output file or folder `output` would replace the input `input`: if
/// it is that file, or one of what the program reads of a house or a report.  An empty `output` is
/// none.
void refuseToReplace(const std::string& output, const std::string& input);

}  // namespace enfilade
