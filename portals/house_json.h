#pragma once

#include <cstdint>
#include <string>

#include "portals/house.h"

namespace enfilade {

/// The text of house.json: all of `house` but its building and grid, and `files`, all that are
/// beside it.  Ends with a checksum of itself.  The same text for the same house.
std::string encodeHouseJson(const House& house, const HouseFiles& files);

/// Fills all of `house` but building and grid.  Throws Error (kBadInput) that names `file`: not a
/// house, another format version, damaged, values missing or out of range.
void decodeHouseJson(const std::string& text, const std::string& file, House& house);

/// 16 hexadecimal digits.
std::string checksumText(std::uint64_t checksum);

/// The checksum that stands at the end of a house.json: XXH3 64 of the text with this checksum's
/// own digits 0, as 16 hexadecimal digits.  `at` is where they stand.
std::string ownChecksum(std::string text, std::size_t at);

}  // namespace enfilade
