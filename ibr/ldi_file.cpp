#include "ibr/ldi_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/format_version.h"
#include "scene/zstd_frame.h"

namespace enfilade {
namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

constexpr char kMagic[8] = {'E', 'N', 'F', 'L', 'D', 'I', '\r', '\n'};
constexpr int kCompression = 3;
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 25;  // some thirty times a wide one's
constexpr std::uint32_t kLargestWindow = 65536u * kLdiTile;

struct FileHeader {
  char magic[8];
  std::uint32_t version, header_size;
  std::uint32_t width, height;
  std::uint64_t tiles, samples;
  std::uint64_t checksum;
  double center[3], world_from_pixel[9];
};
static_assert(sizeof(FileHeader) == 144);

struct FileTile {
  std::uint16_t x, y;
  std::uint32_t count;
};
static_assert(sizeof(FileTile) == 8);

std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kAt = offsetof(FileHeader, checksum);
  constexpr std::size_t kBeyond = kAt + sizeof(FileHeader::checksum);
  const std::uint64_t before = XXH3_64bits(bytes.data(), kAt);
  return XXH3_64bits_withSeed(bytes.data() + kBeyond, bytes.size() - kBeyond, before);
}

[[noreturn]] void reject(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, file, reason);
}

/// The header of a file that begins with `bytes`.
FileHeader readHeader(const std::string& file, std::span<const std::uint8_t> bytes) {
  if (bytes.size() < sizeof(kMagic) || std::memcmp(bytes.data(), kMagic, sizeof(kMagic)) != 0) {
    reject(file, "is not a layered depth image");
  }
  FileHeader header{};
  if (bytes.size() < sizeof(header)) {
    reject(file, "is cut short within its header");
  }
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.version != kLdiFileVersion) {
    reject(file, otherFormatVersion(header.version, kLdiFileVersion));
  }
  if (header.header_size != sizeof(header)) {
    reject(file,
           fmt::format("has a header of {} bytes, not {}", header.header_size, sizeof(header)));
  }
  if (header.tiles > kMostElements || header.samples > kMostElements) {
    reject(file, fmt::format("has sizes that its bytes cannot hold: {} tiles and {} samples",
                             header.tiles, header.samples));
  }
  return header;
}

void checkWindow(const std::string& file, const FileHeader& header) {
  if (header.width > kLargestWindow || header.height > kLargestWindow) {
    reject(file, fmt::format("has a window of {} × {} pixels; {} at most", header.width,
                             header.height, kLargestWindow));
  }
}

PlanarCamera readCamera(const std::string& file, const FileHeader& header) {
  checkWindow(file, header);
  PlanarCamera camera;
  std::memcpy(&camera.center, header.center, sizeof(header.center));
  std::memcpy(&camera.world_from_pixel, header.world_from_pixel, sizeof(header.world_from_pixel));
  camera.width = static_cast<int>(header.width);
  camera.height = static_cast<int>(header.height);
  const double volume = glm::determinant(camera.world_from_pixel);
  if (!std::isfinite(glm::dot(camera.center, camera.center)) || !std::isfinite(1.0 / volume) ||
      !std::isfinite(volume)) {
    reject(file, "has a camera that sees nothing");
  }
  return camera;
}

/// Throws unless the tiles lie in the window in order and hold all samples, each in its order.
void checkTiles(const std::string& file, const Ldi& ldi) {
  const int columns = (ldi.camera.width + kLdiTile - 1) / kLdiTile;
  const int rows = (ldi.camera.height + kLdiTile - 1) / kLdiTile;
  std::uint64_t samples = 0;
  std::int64_t last = -1;
  for (const LdiTile& tile : ldi.tiles) {
    const std::int64_t place = std::int64_t{tile.y} * columns + tile.x;
    if (tile.x >= columns || tile.y >= rows || place <= last || tile.count == 0 ||
        tile.count > ldi.samples.size() - samples) {
      reject(file, fmt::format("has a tile ({}, {}) that is out of place", tile.x, tile.y));
    }
    for (std::uint64_t i = samples + 1; i < samples + tile.count; ++i) {
      if (ldi.samples[i].place < ldi.samples[i - 1].place) {
        reject(file, fmt::format("has samples in tile ({}, {}) that are not in depth order", tile.x,
                                 tile.y));
      }
    }
    last = place;
    samples += tile.count;
  }
  if (samples != ldi.samples.size()) {
    reject(file, "has samples that belong to no tile");
  }
}

}  // namespace

void writeLdi(const std::string& file, const Ldi& ldi) {
  FileHeader header{};
  std::memcpy(header.magic, kMagic, sizeof(kMagic));
  header.version = kLdiFileVersion;
  header.header_size = sizeof(header);
  header.width = static_cast<std::uint32_t>(ldi.camera.width);
  header.height = static_cast<std::uint32_t>(ldi.camera.height);
  header.tiles = ldi.tiles.size();
  header.samples = ldi.samples.size();
  std::memcpy(header.center, &ldi.camera.center, sizeof(header.center));
  std::memcpy(header.world_from_pixel, &ldi.camera.world_from_pixel,
              sizeof(header.world_from_pixel));

  std::vector<std::uint8_t> payload(8 * (ldi.tiles.size() + ldi.samples.size()));
  std::uint8_t* at = payload.data();
  for (const LdiTile& tile : ldi.tiles) {
    const FileTile packed{tile.x, tile.y, tile.count};
    std::memcpy(at, &packed, sizeof(packed));
    at += sizeof(packed);
  }
  if (!ldi.samples.empty()) {
    std::memcpy(at, ldi.samples.data(), sizeof(LdiSample) * ldi.samples.size());
  }
  const std::vector<std::uint8_t> frame = compressFrame(payload, kCompression);
  std::vector<std::uint8_t> bytes(sizeof(header));
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  std::memcpy(bytes.data(), &header, sizeof(header));
  header.checksum = checksumOf(bytes);
  std::memcpy(bytes.data(), &header, sizeof(header));
  writeFileAtomically(file, std::span<const std::uint8_t>(bytes));
}

Ldi decodeLdi(std::span<const std::uint8_t> bytes, const std::string& file) {
  const FileHeader header = readHeader(file, bytes);
  if (checksumOf(bytes) != header.checksum) {
    reject(file, "is cut short or damaged: its checksum does not match");
  }
  Ldi ldi;
  ldi.camera = readCamera(file, header);
  const std::vector<std::uint8_t> payload =
      decompressFrame(bytes.subspan(sizeof(header)), 8 * (header.tiles + header.samples), file);
  ldi.tiles.resize(header.tiles);
  const std::uint8_t* at = payload.data();
  for (LdiTile& tile : ldi.tiles) {
    FileTile packed{};
    std::memcpy(&packed, at, sizeof(packed));
    tile.x = packed.x;
    tile.y = packed.y;
    tile.count = packed.count;
    at += sizeof(packed);
  }
  ldi.samples.resize(header.samples);
  if (!ldi.samples.empty()) {
    std::memcpy(ldi.samples.data(), at, sizeof(LdiSample) * ldi.samples.size());
  }
  checkTiles(file, ldi);
  indexTiles(ldi);
  return ldi;
}

Ldi readLdi(const std::string& file) { return decodeLdi(readFile(file), file); }

std::size_t ldiBytesOfFile(const std::string& file) {
  const FileHeader header = readHeader(file, readFileStart(file, sizeof(FileHeader)));
  checkWindow(file, header);
  if (header.samples == 0) return 0;
  return ldiBytes(static_cast<int>(header.width), static_cast<int>(header.height), header.tiles,
                  header.samples);
}

}  // namespace enfilade
