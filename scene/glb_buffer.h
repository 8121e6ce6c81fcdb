#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace enfilade {

/// The binary chunk of a GLB in the making: remembers what belongs where and copies it once.
class GlbBuffer {
 public:
  /// Appends at the next multiple of four.  What `bytes` points to must outlive this.  Returns the
  /// offset.
  std::size_t add(std::span<const std::uint8_t> bytes);

  /// The same for bytes that are kept here.
  std::size_t addOwned(std::vector<std::uint8_t> bytes);

  /// The same for indices, written as 16-bit numbers: all must be less than 65535.
  std::size_t addAs16Bit(std::span<const std::uint32_t> indices);

  /// Bytes so far, padded to four.
  std::size_t size() const noexcept { return size_; }

  /// The whole GLB.  Throws Error (kMachine) that names `subject` if it would pass 4 GiB.
  /// Source: Khronos, glTF 2.0 specification, section 4.4.
  std::vector<std::uint8_t> encode(const std::string& json, const std::string& subject) const;

 private:
  struct Piece {
    std::size_t offset = 0;
    std::span<const std::uint8_t> bytes{};
    std::span<const std::uint32_t> to_16_bit{};
  };
  std::size_t place(Piece piece, std::size_t byte_count);

  std::vector<Piece> pieces_;
  std::deque<std::vector<std::uint8_t>> owned_;
  std::size_t size_ = 0;
};

}  // namespace enfilade
