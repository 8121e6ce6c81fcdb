#include "portals/grid_file.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>

#include "scene/error.h"
#include "scene/format_version.h"
#include "scene/zstd_frame.h"

namespace enfilade {

namespace {

constexpr std::size_t kHeaderBytes = 64;
constexpr std::size_t kChecksumAt = 56;
constexpr char kMagic[9] = "EnfCells";
constexpr std::uint32_t kVersion = 1;
constexpr int kCompression = 6;
/// Zstd's blocks give 128 KiB for 4 bytes at the very best.
constexpr std::uint64_t kMostPerByte = 32768;
// So that reading one takes less than 1 GiB.
constexpr std::uint64_t kMostColumns = std::uint64_t{1} << 25, kMostRuns = std::uint64_t{1} << 26;

template <typename T>
void put(std::vector<std::uint8_t>& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

template <typename T>
T get(const std::uint8_t* bytes) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    value = static_cast<T>(value | static_cast<T>(static_cast<T>(bytes[i]) << (8 * i)));
  }
  return value;
}

void putFloat(std::vector<std::uint8_t>& bytes, float value) {
  put(bytes, std::bit_cast<std::uint32_t>(value));
}

float getFloat(const std::uint8_t* bytes) {
  return std::bit_cast<float>(get<std::uint32_t>(bytes));
}

/// XXH3 64 of a file as if its own checksum were 0.
std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, kHeaderBytes> header{};
  std::copy_n(bytes.begin(), kChecksumAt, header.begin());
  const std::uint64_t seed = XXH3_64bits(header.data(), header.size());
  return XXH3_64bits_withSeed(bytes.data() + kHeaderBytes, bytes.size() - kHeaderBytes, seed);
}

std::vector<std::uint8_t> payloadOf(const CellGrid& grid) {
  std::vector<std::uint8_t> payload;
  payload.reserve(2 * grid.firstRuns().size() + 4 * grid.runs().size());
  for (std::size_t i = 1; i < grid.firstRuns().size(); ++i) {
    put(payload, static_cast<std::uint16_t>(grid.firstRuns()[i] - grid.firstRuns()[i - 1]));
  }
  for (const CellGrid::Run& run : grid.runs()) put(payload, run.end_y);
  for (const CellGrid::Run& run : grid.runs()) put(payload, run.label);
  return payload;
}

struct Header {
  glm::ivec3 size{0};
  glm::vec3 origin{0};
  float voxel = 0;
  std::uint64_t columns = 0;
  std::uint64_t runs = 0;
};

class GridReader {
 public:
  GridReader(std::span<const std::uint8_t> bytes, const std::string& file)
      : bytes_(bytes), file_(file) {}

  CellGrid read() const {
    const Header header = readHeader();
    const std::vector<std::uint8_t> payload =
        decompressFrame(bytes_.subspan(kHeaderBytes), 2 * header.columns + 4 * header.runs, file_);
    std::vector<std::uint32_t> first(header.columns + 1, 0);
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < header.columns; ++i) {
      total += get<std::uint16_t>(&payload[2 * i]);
      require(total <= header.runs, "its columns have more runs than there are");
      first[i + 1] = static_cast<std::uint32_t>(total);
    }
    const std::uint8_t* ends = payload.data() + 2 * header.columns;
    const std::uint8_t* labels = ends + 2 * header.runs;
    std::vector<CellGrid::Run> runs(header.runs);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[i] = {get<std::uint16_t>(ends + 2 * i), get<std::uint16_t>(labels + 2 * i)};
    }
    try {
      return {header.origin, header.voxel, header.size, std::move(first), std::move(runs)};
    } catch (const Error& error) {
      throw Error(ErrorKind::kBadInput, file_, error.what());
    }
  }

 private:
  void require(bool good, const std::string& reason) const {
    if (!good) throw Error(ErrorKind::kBadInput, file_, reason);
  }

  Header readHeader() const {
    require(bytes_.size() >= 8 && std::memcmp(bytes_.data(), kMagic, 8) == 0, "is not a cell grid");
    require(bytes_.size() >= kHeaderBytes, "is cut short");
    const std::uint8_t* at = bytes_.data() + 8;
    const auto version = get<std::uint32_t>(at);
    require(version == kVersion, otherFormatVersion(version, kVersion));
    Header header;
    for (int axis = 0; axis < 3; ++axis) {
      const auto size = get<std::uint32_t>(at + 4 + 4 * axis);
      require(size >= 1 && size <= 65535, "has a size that is not in 1…65535");
      header.size[axis] = static_cast<int>(size);
      header.origin[axis] = getFloat(at + 16 + 4 * axis);
    }
    header.voxel = getFloat(at + 28);
    header.runs = get<std::uint64_t>(at + 32);
    header.columns =
        static_cast<std::uint64_t>(header.size.x) * static_cast<std::uint64_t>(header.size.z);
    require(get<std::uint64_t>(at + 40) == bytes_.size() - kHeaderBytes,
            "has not the length that it says: cut short, or followed by something else");
    require(get<std::uint64_t>(at + 48) == checksumOf(bytes_), "is damaged: its checksum differs");
    require(header.runs >= header.columns && header.runs <= 0xffffffffu,
            "has an impossible number of runs");
    const std::uint64_t payload = 2 * header.columns + 4 * header.runs;
    require(payload / kMostPerByte <= bytes_.size(), "has sizes that its bytes cannot hold");
    require(header.columns <= kMostColumns && header.runs <= kMostRuns,
            "is too large: 2^25 columns and 2^26 runs can be read");
    return header;
  }

  std::span<const std::uint8_t> bytes_;
  const std::string& file_;
};

}  // namespace

std::vector<std::uint8_t> encodeGrid(const CellGrid& grid) {
  const std::vector<std::uint8_t> payload = compressFrame(payloadOf(grid), kCompression);
  std::vector<std::uint8_t> bytes(kMagic, kMagic + 8);
  put(bytes, kVersion);
  for (int axis = 0; axis < 3; ++axis) put(bytes, static_cast<std::uint32_t>(grid.size()[axis]));
  for (int axis = 0; axis < 3; ++axis) putFloat(bytes, grid.origin()[axis]);
  putFloat(bytes, grid.voxel());
  put(bytes, static_cast<std::uint64_t>(grid.runs().size()));
  put(bytes, static_cast<std::uint64_t>(payload.size()));
  put(bytes, std::uint64_t{0});
  assert(bytes.size() == kHeaderBytes);
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  std::vector<std::uint8_t> checksum;
  put(checksum, checksumOf(bytes));
  std::copy(checksum.begin(), checksum.end(), bytes.begin() + kChecksumAt);
  return bytes;
}

CellGrid decodeGrid(std::span<const std::uint8_t> bytes, const std::string& file) {
  return GridReader(bytes, file).read();
}

}  // namespace enfilade
