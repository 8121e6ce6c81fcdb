#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace enfilade {

/// How pixels are made of warped samples.
///
/// The paper's: a sample paints its splat over whatever stands there, so that the occlusion-
/// compatible order alone decides what is seen.
/// - k1x1, k2x2, k3x3: the pixels nearest to where the sample falls
/// - kCross: the pixel, and the four beside it
/// - kSized: the pixels that the sample's patch of surface covers as it appears from the desired
/// eye
///
/// And beyond it, by a depth a pixel: of the samples whose patch covers a pixel's centre the
/// nearest surface counts, and of that surface
/// - kNearest: the sample that falls nearest to the pixel's centre, as patches go
/// - kMean: the mean of all that cover it
/// Then a pixel between two of one nearer surface is taken for a crack in it, and closed.
/// Source: Rafferty et al. 1998, sec. 3.1.
enum class Splat : std::uint8_t { k1x1, k2x2, k3x3, kCross, kSized, kNearest, kMean };

struct SplatInfo {
  Splat splat;
  const char* name;         ///< on the command line and in reports
  const char* description;  ///< in a few words
};

/// Every splat there is, in the order of Splat.
std::span<const SplatInfo> allSplats();

const SplatInfo& infoOf(Splat splat);

/// Whether the splat keeps a depth a pixel, so that the order of samples hardly matters.
inline bool keepsDepth(Splat splat) noexcept { return splat >= Splat::kNearest; }

}  // namespace enfilade
