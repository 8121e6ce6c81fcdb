#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace enfilade {

/// The whole file.  Throws Error (kBadInput): "no such file", "is a directory", "cannot be read:
/// …".
std::vector<std::uint8_t> readFile(const std::string& file);

/// Its first `most` bytes, or all if there are fewer.  Throws as readFile() does.
std::vector<std::uint8_t> readFileStart(const std::string& file, std::size_t most);

/// Writes to FILE.tmp-PID beside `file`, then renames: the old content or the new, never half.
/// Throws Error (kMachine) with the system's reason, and leaves no temporary file behind.
void writeFileAtomically(const std::string& file, std::span<const std::uint8_t> bytes);
void writeFileAtomically(const std::string& file, const std::string& text);

/// Creates `folder` and its parents.  Throws Error (kMachine) with the system's reason.
void createFolders(const std::string& folder);

/// SHA-256 in lower-case hexadecimal.
std::string sha256Hex(std::span<const std::uint8_t> bytes);

}  // namespace enfilade
