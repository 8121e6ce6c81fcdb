#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade {

/// The whole file.  Throws Error (kBadInput): "no such file", "is a directory", "cannot be read:
/// …", and if it has more than `most` bytes, before it is read.
std::vector<std::uint8_t> readFile(const std::string& file,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// What a file of text of a kind that people write, or look into, has at most [bytes].
inline constexpr std::uint64_t kMostTextBytes = std::uint64_t{64} << 20;

/// Its first `most` bytes, or all if there are fewer.  Throws as readFile() does.
std::vector<std::uint8_t> readFileStart(const std::string& file, std::size_t most);

/// What stands between the name of a file or folder and numbers while it is written.
inline constexpr std::string_view kTemporaryMark = ".tmp-";

/// The file that replaces `file` when it is written: where that is a symbolic link, which stays
/// one, what it leads to, there already or not.  Throws Error (kMachine) for a link to itself.
std::string targetOf(const std::string& file);

/// A new, empty file FILE.tmp-PID, or FILE.tmp-PID-N if there are such, beside `file`: its name.
/// Nobody else's, even where processes of several machines write to one folder.  Throws Error
/// (kMachine) that names `file`, with the system's reason.
std::string createTemporary(const std::string& file);

/// Likewise a folder.
std::string createTemporaryFolder(const std::string& folder);

/// Writes to FILE.tmp-PID beside `file`, then renames: the old content or the new, never half.
/// What the shell has opened, such as /dev/stdout, is written on.
/// Throws Error (kMachine) with the system's reason, and leaves no temporary file behind.
void writeFileAtomically(const std::string& file, std::span<const std::uint8_t> bytes);
void writeFileAtomically(const std::string& file, const std::string& text);

/// Removes the temporary files of what writeFileAtomically() is writing, for a program that is
/// about to be ended by a signal: may be called in a handler of one.
void removeHalfWrittenFiles() noexcept;

/// Creates `folder` and its parents.  Throws Error (kMachine) with the system's reason.
void createFolders(const std::string& folder);

/// SHA-256 in lower-case hexadecimal.
std::string sha256Hex(std::span<const std::uint8_t> bytes);

}  // namespace enfilade
