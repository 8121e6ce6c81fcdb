#pragma once

#include <string>

#include "ibr/ldi.h"

namespace enfilade {

/// Writes `ldi` to one binary file: magic, version, sizes, checksum, little-endian; by way of a
/// temporary name. The same bytes for the same LDI.  Throws Error (kMachine).
void writeLdi(const std::string& file, const Ldi& ldi);

/// Throws Error (kBadInput): cut short, another version, sizes that do not fit the file, a checksum
/// that does not match.
Ldi readLdi(const std::string& file);

}  // namespace enfilade
