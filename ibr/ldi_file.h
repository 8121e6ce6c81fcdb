#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "ibr/ldi.h"

namespace enfilade {

/// The file of a layered depth image, little-endian:
///
///     offset  bytes
///          0      8  "ENFLDI\r\n"
///          8      4  version, 2
///         12      4  bytes of this header, 144
///         16      8  width and height of the window [pixels]
///         24     16  number of tiles, number of samples
///         40      8  XXH3 of all other bytes of the file, in order
///         48     96  camera: center, then world_from_pixel's columns, as doubles
///        144         one Zstandard frame, to the file's end, of:
///                 8  a tile: x, y (2 bytes each), number of samples (4); by row, then by column
///                 8  a sample: r, g, b, footprint, place (4), as in LdiSample; tile after tile
inline constexpr std::uint32_t kLdiFileVersion = 2;

/// Writes `ldi` by way of a temporary name.  The same bytes for the same LDI.  Throws Error
/// (kMachine).
void writeLdi(const std::string& file, const Ldi& ldi);

/// The LDI of a file's bytes; `file` names it in errors.  Throws Error (kBadInput): not an LDI,
/// another version and what to do, cut short, sizes that do not fit the file (nothing is allocated
/// before they do), a checksum that does not match, tiles or samples that are not where they should
/// be.
Ldi decodeLdi(std::span<const std::uint8_t> bytes, const std::string& file);
Ldi readLdi(const std::string& file);  ///< likewise

/// The bytes that the image in `file` will take in memory, by its header alone: nothing else of it
/// is read or checked.  0: it has no samples.  Throws Error (kBadInput) as readLdi() does for what
/// the header says.
std::size_t ldiBytesOfFile(const std::string& file);

/// The same of the bytes of `file`.
Ldi decodeLdi(std::span<const std::uint8_t> bytes, const std::string& file);

}  // namespace enfilade
