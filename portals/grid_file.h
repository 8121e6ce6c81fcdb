#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "portals/cell_grid.h"

namespace enfilade {

/// The file cells.grid.  Little-endian: a header of 64 bytes,
///   char magic[8] = "EnfCells"; u32 version = 1; u32 size_x, size_y, size_z; f32 origin[3], voxel;
///   u64 run_count, payload_bytes, checksum (XXH3 64 of the payload, seeded by that of the header
///   with a checksum of 0);
/// then the payload, one zstd frame of u16 runs_of_column[size_x · size_z], u16 end_y[run_count],
/// u16 label[run_count].  The same bytes for the same grid.
std::vector<std::uint8_t> encodeGrid(const CellGrid& grid);

/// Throws Error (kBadInput) that names `file`: another format or version, cut short, a checksum
/// that does not match, sizes that its bytes cannot hold (before anything of that size is
/// allocated), runs that make no grid.
CellGrid decodeGrid(std::span<const std::uint8_t> bytes, const std::string& file);

}  // namespace enfilade
