#include "tests/fuzz/containers.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "portals/house_json.h"
#include "scene/zstd_frame.h"

namespace enfilade::fuzz {
namespace {

using Buffer = std::vector<std::uint8_t>;

template <typename Number>
void put(Buffer& bytes, Number value) {
  const auto* begin = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), begin, begin + sizeof(value));
}

void put(Buffer& bytes, Bytes more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

template <typename Number>
Number numberAt(Bytes bytes, std::size_t offset) {
  Number value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

template <typename Number>
void setNumberAt(Buffer& bytes, std::size_t offset, Number value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(value));
}

bool beginsWith(Bytes bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

bool isZstdFrame(Bytes bytes) { return beginsWith(bytes, "\x28\xb5\x2f\xfd"); }

/// The bytes of `header`, then `payload` as a Zstandard frame.
Buffer framed(Bytes header, Bytes payload) {
  Buffer bytes(header.begin(), header.end());
  if (isZstdFrame(payload)) {
    put(bytes, payload);
  } else {
    put(bytes, Bytes(compressFrame(payload, 1)));
  }
  return bytes;
}

std::uint32_t crcOf(Bytes bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

/// What a ZIP says of an entry, both before it and in its directory.
void putFacts(Buffer& zip, const std::string& name, Bytes content) {
  put(zip, std::uint16_t{20});  // version
  put(zip, std::uint16_t{0});   // flags
  put(zip, std::uint16_t{0});   // stored
  put(zip, std::uint32_t{0});   // time
  put(zip, crcOf(content));
  put(zip, static_cast<std::uint32_t>(content.size()));
  put(zip, static_cast<std::uint32_t>(content.size()));
  put(zip, static_cast<std::uint16_t>(name.size()));
  put(zip, std::uint16_t{0});  // extra
}

}  // namespace

std::vector<std::uint8_t> glbOf(Bytes input) {
  if (beginsWith(input, "glTF")) return {input.begin(), input.end()};
  Bytes rest = input;
  const Bytes json = takePart(rest);
  const std::size_t padded = (json.size() + 3) / 4 * 4;
  Buffer glb;
  put(glb, std::uint32_t{0x46546c67});
  put(glb, std::uint32_t{2});
  put(glb, static_cast<std::uint32_t>(12 + 8 + padded + 8 + rest.size()));
  put(glb, static_cast<std::uint32_t>(padded));
  put(glb, std::uint32_t{0x4e4f534a});
  put(glb, json);
  glb.resize(20 + padded, ' ');
  put(glb, static_cast<std::uint32_t>(rest.size()));
  put(glb, std::uint32_t{0x004e4942});
  put(glb, rest);
  return glb;
}

std::vector<std::uint8_t> zipOf(const std::vector<std::pair<std::string, Bytes>>& entries) {
  Buffer zip, directory;
  for (const auto& [name, content] : entries) {
    put(directory, std::uint32_t{0x02014b50});
    put(directory, std::uint16_t{20});
    putFacts(directory, name, content);
    put(directory, std::uint16_t{0});  // comment
    put(directory, std::uint32_t{0});  // disk, attributes
    put(directory, std::uint32_t{0});
    put(directory, static_cast<std::uint32_t>(zip.size()));
    put(directory, Bytes(reinterpret_cast<const std::uint8_t*>(name.data()), name.size()));
    put(zip, std::uint32_t{0x04034b50});
    putFacts(zip, name, content);
    put(zip, Bytes(reinterpret_cast<const std::uint8_t*>(name.data()), name.size()));
    put(zip, content);
  }
  const auto start = static_cast<std::uint32_t>(zip.size());
  put(zip, Bytes(directory));
  put(zip, std::uint32_t{0x06054b50});
  put(zip, std::uint32_t{0});  // disks
  put(zip, static_cast<std::uint16_t>(entries.size()));
  put(zip, static_cast<std::uint16_t>(entries.size()));
  put(zip, static_cast<std::uint32_t>(directory.size()));
  put(zip, start);
  put(zip, std::uint16_t{0});  // comment
  return zip;
}

std::vector<std::uint8_t> sealGrid(Bytes input) {
  constexpr std::size_t kHeader = 64, kSizeX = 12, kSizeZ = 20, kRuns = 40, kPayload = 48,
                        kChecksum = 56;
  if (input.size() < kHeader) return {input.begin(), input.end()};
  const Bytes payload = input.subspan(kHeader);
  Buffer bytes = framed(input.first(kHeader), payload);
  const std::uint64_t columns = std::uint64_t{numberAt<std::uint32_t>(input, kSizeX)} *
                                numberAt<std::uint32_t>(input, kSizeZ);
  if (!isZstdFrame(payload) && columns <= payload.size() / 2) {
    setNumberAt<std::uint64_t>(bytes, kRuns, (payload.size() - 2 * columns) / 4);
  }
  setNumberAt<std::uint64_t>(bytes, kPayload, bytes.size() - kHeader);
  setNumberAt<std::uint64_t>(bytes, kChecksum, 0);
  const std::uint64_t seed = XXH3_64bits(bytes.data(), kHeader);
  setNumberAt<std::uint64_t>(
      bytes, kChecksum, XXH3_64bits_withSeed(bytes.data() + kHeader, bytes.size() - kHeader, seed));
  return bytes;
}

std::vector<std::uint8_t> sealLdi(Bytes input) {
  constexpr std::size_t kHeader = 144, kTiles = 24, kSamples = 32, kChecksum = 40;
  if (input.size() < kHeader) return {input.begin(), input.end()};
  const Bytes payload = input.subspan(kHeader);
  const Bytes whole = isZstdFrame(payload) ? payload : payload.first(payload.size() / 8 * 8);
  Buffer bytes = framed(input.first(kHeader), whole);
  const auto tiles = numberAt<std::uint64_t>(input, kTiles);
  if (!isZstdFrame(payload) && tiles <= whole.size() / 8) {
    setNumberAt<std::uint64_t>(bytes, kSamples, whole.size() / 8 - tiles);
  }
  const std::uint64_t before = XXH3_64bits(bytes.data(), kChecksum);
  setNumberAt<std::uint64_t>(
      bytes, kChecksum,
      XXH3_64bits_withSeed(bytes.data() + kChecksum + 8, bytes.size() - kChecksum - 8, before));
  return bytes;
}

std::string sealHouseJson(std::string text) {
  const std::size_t end = text.rfind('"');
  if (end == std::string::npos || end < 17 || text[end - 17] != '"') return text;
  text.replace(end - 16, 16, ownChecksum(text, end - 16));
  return text;
}

}  // namespace enfilade::fuzz
