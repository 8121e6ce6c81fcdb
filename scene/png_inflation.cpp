#include "scene/png_inflation.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "scene/png_chunks.h"

namespace enfilade {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kMostOfAByte = 1032;                 // that deflate makes
constexpr std::size_t kHarmless = std::size_t{256} << 20;  // [bytes]

bool isData(const char* type) { return std::memcmp(type, "IDAT", 4) == 0; }

/// Inflates into nothing, and counts.
class Counter {
 public:
  explicit Counter(std::size_t most) : most_(most) { inflateInit2(&stream_, -MAX_WBITS); }
  ~Counter() { inflateEnd(&stream_); }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  /// False when no more is wanted.
  bool take(Bytes data) {
    stream_.next_in = const_cast<Bytef*>(data.data());
    stream_.avail_in = static_cast<uInt>(data.size());
    int status = Z_OK;
    while (status == Z_OK && (stream_.avail_in > 0 || stream_.avail_out == 0)) {
      stream_.next_out = scratch_.data();
      stream_.avail_out = static_cast<uInt>(scratch_.size());
      status = ::inflate(&stream_, Z_NO_FLUSH);
      inflated_ += scratch_.size() - stream_.avail_out;
      if (inflated_ > most_) return false;
    }
    damaged_ = status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR;
    return status == Z_OK || status == Z_BUF_ERROR;
  }

  PngInflation result() const {
    if (inflated_ > most_) return PngInflation::kTooMuch;
    return damaged_ ? PngInflation::kDamaged : PngInflation::kFits;
  }

 private:
  std::size_t most_;
  z_stream stream_{};
  std::size_t inflated_ = 0;
  bool damaged_ = false;
  std::array<std::uint8_t, 65536> scratch_{};
};

}  // namespace

PngInflation inflatePng(Bytes png, std::size_t most) {
  std::size_t bytes = 0;
  bool has_header = true;
  forEachPngChunk(png, [&](const char* type, Bytes content) {
    if (isData(type)) bytes += content.size();
    if (std::memcmp(type, "CgBI", 4) == 0) has_header = false;  // Apple's own PNGs have none
    return true;
  });
  if (bytes <= std::max(kHarmless, most) / kMostOfAByte) return PngInflation::kFits;
  Counter counter(most);
  std::size_t header = has_header ? 2 : 0;  // decoders do not agree on what is wrong with one
  forEachPngChunk(png, [&](const char* type, Bytes content) {
    if (!isData(type)) return true;
    const std::size_t skipped = std::min(header, content.size());
    header -= skipped;
    return counter.take(content.subspan(skipped));
  });
  return counter.result();
}

}  // namespace enfilade
