#pragma once

#include <string>

namespace enfilade {

/// Why a file of format version `found` is not read by a program that reads `ours`, and what to do:
/// what is older is made again, what is newer asks for a newer program.
std::string otherFormatVersion(double found, double ours);

}  // namespace enfilade
