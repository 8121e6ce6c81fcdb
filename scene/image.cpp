#include "scene/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <memory>

#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/jpeg_tables.h"
#include "scene/png_chunks.h"
#include "scene/png_inflation.h"

namespace enfilade {
namespace {

/// The largest side of a picture that we decode: the most that common GPUs take.
constexpr int kMaxSide = 16384;
/// Its most pixels: decoders need up to 17 bytes for each.
constexpr std::int64_t kMaxPixels = std::int64_t{8192} * 8192;

/// The most pixels that a byte of a file can stand for.  PNG: of one bit each, and its compression
/// makes 1032 bytes at most of one.  JPEG: 64 for a bit, a block of the same colour as the last.
constexpr std::int64_t kPngPixelsPerByte = 8 * 1032;
constexpr std::int64_t kJpegPixelsPerByte = 8 * 64;

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* begin = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
}

[[noreturn]] void fail(const std::string& subject, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, subject, reason);
}

/// Throws unless a picture of this size may be decoded.
void requireSize(int width, int height, const std::string& subject) {
  const std::int64_t pixels = std::int64_t{width} * height;
  if (width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide &&
      pixels <= kMaxPixels) {
    return;
  }
  fail(subject, "is " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels; at most 8192 x 8192 can be read, or 16384 x 4096");
}

/// Throws if a chunk of a PNG says that it is longer than what is left: the decoder would ask for
/// all of that at once.
void requireWholeChunks(std::span<const std::uint8_t> bytes, const std::string& subject) {
  const auto pass = [](const char*, std::span<const std::uint8_t>) { return true; };
  if (!forEachPngChunk(bytes, pass))
    fail(subject, "cannot be decoded: it is cut short, or damaged");
}

/// Throws unless a picture of this size may be decoded and can be in `bytes`.
void requireFittingSize(int width, int height, std::span<const std::uint8_t> bytes,
                        const std::string& subject) {
  requireSize(width, height, subject);
  const std::int64_t pixels = std::int64_t{width} * height;
  const std::int64_t each =
      imageMimeType(bytes) == "image/png" ? kPngPixelsPerByte : kJpegPixelsPerByte;
  if (pixels / each > std::ssize(bytes)) {
    fail(subject, "says that it is " + std::to_string(width) + " x " + std::to_string(height) +
                      " pixels, more than its bytes can hold");
  }
}

/// Throws for a PNG whose data inflate to much more than its picture needs.
void requireFittingData(int width, int height, std::span<const std::uint8_t> bytes,
                        const std::string& subject) {
  constexpr std::size_t kMostOfAPixel = 8, kMostOfARow = 16, kSlack = 65536;  // of 16 bits, RGBA
  const auto rows = static_cast<std::size_t>(height);
  const std::size_t most =
      kMostOfAPixel * static_cast<std::size_t>(width) * rows + kMostOfARow * rows + kSlack;
  const PngInflation inflation = inflatePng(bytes, most);
  if (inflation == PngInflation::kFits) return;
  fail(subject, inflation == PngInflation::kTooMuch
                    ? "cannot be decoded: it holds far more data than its pixels need"
                    : "cannot be decoded: it is damaged");
}

/// Throws for a JPEG that goes over its picture more often than any needs.
void requireFewScans(int width, int height, std::span<const std::uint8_t> bytes,
                     const std::string& subject) {
  constexpr std::size_t kMostScannedPixels = std::size_t{1} << 31;
  const std::size_t scans = countJpegScans(bytes);
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (scans > kMostScannedPixels / pixels) {
    fail(subject, "cannot be decoded: it has " + std::to_string(scans) + " scans");
  }
}

}  // namespace

std::string imageMimeType(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::array<std::uint8_t, 3> kJpeg{0xff, 0xd8, 0xff};
  const auto begins = [&](const auto& magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
  };
  if (begins(kPng)) return "image/png";
  if (begins(kJpeg)) return "image/jpeg";
  return {};
}

Image decodeImage(const std::vector<std::uint8_t>& bytes, const std::string& subject) {
  if (imageMimeType(bytes).empty()) fail(subject, "is neither a PNG nor a JPEG image");
  if (bytes.size() > std::numeric_limits<int>::max()) fail(subject, "is too large for an image");
  if (imageMimeType(bytes) == "image/png") requireWholeChunks(bytes, subject);
  const int size = static_cast<int>(bytes.size());
  Image image;
  int channels = 0;
  if (!stbi_info_from_memory(bytes.data(), size, &image.width, &image.height, &channels)) {
    fail(subject, std::string("cannot be decoded: ") + stbi_failure_reason());
  }
  requireFittingSize(image.width, image.height, bytes, subject);
  if (imageMimeType(bytes) == "image/png") {
    requireFittingData(image.width, image.height, bytes, subject);
  } else {
    if (!hasSoundJpegTables(bytes)) {
      fail(subject, "cannot be decoded: a table that it needs is damaged or not there");
    }
    requireFewScans(image.width, image.height, bytes, subject);
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), size, &image.width, &image.height, &channels, 4),
      stbi_image_free);
  if (!pixels) fail(subject, std::string("cannot be decoded: ") + stbi_failure_reason());
  const std::size_t count = std::size_t{4} * static_cast<std::size_t>(image.width) *
                            static_cast<std::size_t>(image.height);
  image.rgba.assign(pixels.get(), pixels.get() + count);
  return image;
}

Image readImage(const std::string& file) { return decodeImage(readFile(file), file); }

glm::ivec2 readImageSize(const std::string& file) {
  constexpr std::size_t kMagic = 8;
  if (imageMimeType(readFileStart(file, kMagic)).empty()) {
    fail(file, "is neither a PNG nor a JPEG image");
  }
  glm::ivec2 size(0);
  int channels = 0;
  if (!stbi_info(file.c_str(), &size.x, &size.y, &channels)) {
    fail(file, std::string("cannot be decoded: ") + stbi_failure_reason());
  }
  requireSize(size.x, size.y, file);
  return size;
}

std::vector<std::uint8_t> encodePng(const Image& image) {
  assert(image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                  static_cast<std::size_t>(image.height));
  std::vector<std::uint8_t> bytes;
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                              4 * image.width)) {
    throw Error(ErrorKind::kMachine, "", "no memory to encode a PNG image");
  }
  return bytes;
}

std::vector<std::uint8_t> encodeJpeg(const Image& image, int quality) {
  assert(quality >= 1 && quality <= 100);
  std::vector<std::uint8_t> bytes;
  if (!stbi_write_jpg_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                              quality)) {
    throw Error(ErrorKind::kMachine, "", "no memory to encode a JPEG image");
  }
  return bytes;
}

void writePng(const std::string& file, const Image& image) {
  writeFileAtomically(file, encodePng(image));
}

}  // namespace enfilade
