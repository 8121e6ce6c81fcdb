#include "scene/zstd_frame.h"

#include <zstd.h>

#include "scene/error.h"

namespace enfilade {
namespace {

// Zstandard's blocks hold 128 KiB at most, and take 4 bytes at least.
constexpr std::uint64_t kMostPerByte = 32768;
// So that a small file cannot ask for all memory.
constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20;

}  // namespace

std::vector<std::uint8_t> compressFrame(std::span<const std::uint8_t> payload, int level) {
  std::vector<std::uint8_t> frame(ZSTD_compressBound(payload.size()));
  const std::size_t size =
      ZSTD_compress(frame.data(), frame.size(), payload.data(), payload.size(), level);
  if (ZSTD_isError(size)) throw Error(ErrorKind::kMachine, "zstd", ZSTD_getErrorName(size));
  frame.resize(size);
  return frame;
}

std::vector<std::uint8_t> decompressFrame(std::span<const std::uint8_t> frame, std::uint64_t size,
                                          const std::string& file) {
  const auto require = [&](bool holds, const char* otherwise) {
    if (!holds) throw Error(ErrorKind::kBadInput, file, otherwise);
  };
  require(size / kMostPerByte <= frame.size(), "has sizes that its bytes cannot hold");
  require(size <= kMostBytes, "has a payload of over 512 MiB");
  require(ZSTD_getFrameContentSize(frame.data(), frame.size()) == size,
          "has a payload of another size than its header says");
  std::vector<std::uint8_t> payload(size);
  const std::size_t got =
      ZSTD_decompress(payload.data(), payload.size(), frame.data(), frame.size());
  require(!ZSTD_isError(got) && got == size, "has a payload that cannot be decompressed");
  return payload;
}

}  // namespace enfilade
