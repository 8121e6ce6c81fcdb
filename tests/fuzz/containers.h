#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/fuzz/targets.h"

/// What a fuzzer cannot hit by chance, made right: lengths and checksums, so that its changes reach
/// what lies behind them.
namespace enfilade::fuzz {

/// A GLB of JSON \0 binary chunk.  What begins as a GLB is returned as it is.
std::vector<std::uint8_t> glbOf(Bytes input);

/// A ZIP, nothing compressed, of entries by name.
std::vector<std::uint8_t> zipOf(const std::vector<std::pair<std::string, Bytes>>& entries);

/// A cells.grid whose header may say anything and whose payload (not a Zstandard frame: it becomes
/// one, and the number of runs what it has room for) follows; length and checksum become right.
std::vector<std::uint8_t> sealGrid(Bytes input);

/// An LDI's file, likewise.
std::vector<std::uint8_t> sealLdi(Bytes input);

/// A house.json whose last string of 16 characters becomes its checksum.
std::string sealHouseJson(std::string text);

}  // namespace enfilade::fuzz
