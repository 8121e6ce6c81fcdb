#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

struct zip;  // libzip's

namespace enfilade {

/// A ZIP file that is read in memory: nothing is unpacked to disk.
class ZipArchive {
 public:
  /// Throws Error (kBadInput) for a file that is not there or no ZIP.
  explicit ZipArchive(const std::string& file);
  /// Of the bytes of `file`, which need not be there.
  ZipArchive(std::vector<std::uint8_t> bytes, const std::string& file);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// The content of an entry; nothing if there is none of that name, whatever its case.  Throws
  /// Error (kBadInput) for one that is damaged, larger than 256 MiB, larger than its compressed
  /// bytes can hold (before that much is asked for), or compressed by another method than deflate.
  std::optional<std::vector<std::uint8_t>> read(const std::string& name) const;

 private:
  std::string file_;
  std::vector<std::uint8_t> bytes_;  ///< empty: read from the file itself
  ::zip* archive_ = nullptr;
};

}  // namespace enfilade
