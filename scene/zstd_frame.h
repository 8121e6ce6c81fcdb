#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace enfilade {

/// Compresses `payload` into one Zstandard frame that tells its size; the same bytes for the same
/// payload.  `level` as zstd's, 1…19.  Throws Error (kMachine).
std::vector<std::uint8_t> compressFrame(std::span<const std::uint8_t> payload, int level);

/// The payload of `size` bytes, 512 MiB at most, of a frame that compressFrame made.  Nothing is
/// allocated before the frame can hold that much.  Throws Error (kBadInput), which names `file`:
/// another size, too large, or damaged.
std::vector<std::uint8_t> decompressFrame(std::span<const std::uint8_t> frame, std::uint64_t size,
                                          const std::string& file);

}  // namespace enfilade
