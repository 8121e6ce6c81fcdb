#include "scene/glb_buffer.h"

#include <cassert>
#include <cstring>
#include <limits>

#include "scene/error.h"

namespace enfilade {
namespace {

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

void putU32(std::uint8_t* out, std::size_t value) {
  for (int i = 0; i < 4; ++i) out[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

}  // namespace

std::size_t GlbBuffer::place(Piece piece, std::size_t byte_count) {
  piece.offset = size_;
  size_ = padded(size_ + byte_count);
  pieces_.push_back(piece);
  return piece.offset;
}

std::size_t GlbBuffer::add(std::span<const std::uint8_t> bytes) {
  return place({.bytes = bytes}, bytes.size());
}

std::size_t GlbBuffer::addOwned(std::vector<std::uint8_t> bytes) {
  owned_.push_back(std::move(bytes));
  return add(owned_.back());
}

std::size_t GlbBuffer::addAs16Bit(std::span<const std::uint32_t> indices) {
  return place({.to_16_bit = indices}, 2 * indices.size());
}

std::vector<std::uint8_t> GlbBuffer::encode(const std::string& json,
                                            const std::string& subject) const {
  const std::size_t json_size = padded(json.size());
  const std::size_t total = 20 + json_size + (size_ > 0 ? 8 + size_ : 0);
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorKind::kMachine, subject, "does not fit into one GLB file (4 GiB)");
  }
  std::vector<std::uint8_t> glb(total);
  std::memcpy(glb.data(), "glTF", 4);
  putU32(&glb[4], 2);
  putU32(&glb[8], total);
  putU32(&glb[12], json_size);
  std::memcpy(&glb[16], "JSON", 4);
  std::memset(&glb[20], ' ', json_size);
  std::memcpy(&glb[20], json.data(), json.size());
  if (size_ == 0) return glb;

  std::uint8_t* chunk = glb.data() + 20 + json_size;
  putU32(chunk, size_);
  std::memcpy(chunk + 4, "BIN\0", 4);
  std::uint8_t* body = chunk + 8;
  for (const Piece& piece : pieces_) {
    std::uint8_t* out = body + piece.offset;
    if (!piece.bytes.empty()) std::memcpy(out, piece.bytes.data(), piece.bytes.size());
    for (const std::uint32_t index : piece.to_16_bit) {
      assert(index < 65535);
      *out++ = static_cast<std::uint8_t>(index);
      *out++ = static_cast<std::uint8_t>(index >> 8);
    }
  }
  return glb;
}

}  // namespace enfilade
