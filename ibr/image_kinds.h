#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace enfilade {

/// What a side of a portal can have images of: colours alone, colours and disparities from one
/// viewpoint, or a layered depth image.
enum class ImageKind : std::uint8_t { kTexture, kReference, kLdi };

inline constexpr std::array kAllImageKinds = {ImageKind::kTexture, ImageKind::kReference,
                                              ImageKind::kLdi};

/// Some of the kinds of images.
struct ImageKinds {
  bool textures = true;
  bool references = true;
  bool ldis = true;

  bool has(ImageKind kind) const noexcept {
    return kind == ImageKind::kTexture     ? textures
           : kind == ImageKind::kReference ? references
                                           : ldis;
  }
};

/// "texture,warp,ldi": the kinds by the method that shows them first.
std::string imageKindNames(const ImageKinds& kinds);

/// The kinds named in `list`, joined by commas.  Throws Error (kUsage) for a name that is none.
ImageKinds parseImageKinds(const std::string& list);

/// The file names of a side's images in its folder: "ldi.bin", and of viewpoint `index` along the
/// semicircle "texture-00.png" and "reference-00.bin".
std::string ldiFileName();
std::string textureFileName(std::size_t index);
std::string referenceFileName(std::size_t index);

}  // namespace enfilade
