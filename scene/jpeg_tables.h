#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace enfilade {

/// Whether every scan of a JPEG uses tables that stand before it, and each table is whole and no
/// longer than may be.  stb_image takes both for granted, and of a file where it is not so it
/// reads and writes what is not its own.  Of what else may be wrong with a file this says nothing.
/// Source: ITU-T T.81, 1992, annex B.
bool hasSoundJpegTables(std::span<const std::uint8_t> bytes) noexcept;

/// How many scans a JPEG has: a decoder goes over the whole picture for each.
std::size_t countJpegScans(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace enfilade
