#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace enfilade {

/// An 8-bit RGBA picture, row 0 on top, rows packed.  Colours are sRGB as stored, alpha is linear.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 · width · height bytes
};

/// A picture of a building, with the file's own bytes so that it can be written again unchanged.
struct TextureImage {
  std::string name;
  Image image;
  std::vector<std::uint8_t> encoded;  ///< the PNG or JPEG file; empty: encode `image` when writing
  std::string mime_type;              ///< "image/png" or "image/jpeg"; of `encoded`
};

/// Writes `image` as PNG by way of a temporary name.  Throws Error (kMachine) when it cannot.
void writePng(const std::string& file, const Image& image);

/// Reads a PNG or JPEG file.  Throws Error (kBadInput).
Image readImage(const std::string& file);

/// The width and height [pixels] of a PNG or JPEG file, of which nothing else is decoded.  Throws
/// Error (kBadInput).
glm::ivec2 readImageSize(const std::string& file);

/// The PNG file of `image`, in memory.  The same bytes on every run.
std::vector<std::uint8_t> encodePng(const Image& image);

/// The JPEG file of `image`, its alpha left out, in memory; `quality` 1 to 100.  The same bytes on
/// every run.
std::vector<std::uint8_t> encodeJpeg(const Image& image, int quality);

/// Decodes a PNG or JPEG in memory, of at most 8192 × 8192 pixels in any shape up to 16384 on a
/// side; `subject` names it in errors.  Throws Error (kBadInput); of a file that is too small for
/// its pixels before memory for them is asked for.
Image decodeImage(const std::vector<std::uint8_t>& bytes, const std::string& subject);

/// "image/png" or "image/jpeg" by the first bytes; empty for anything else.
std::string imageMimeType(std::span<const std::uint8_t> bytes);

}  // namespace enfilade
