#include "ibr/splat.h"

#include <array>

namespace enfilade {

namespace {

constexpr std::array<SplatInfo, 7> kSplats = {{
    {Splat::k1x1, "1x1", "one pixel"},
    {Splat::k2x2, "2x2", "two by two pixels"},
    {Splat::k3x3, "3x3", "three by three pixels"},
    {Splat::kCross, "cross", "a pixel and the four beside it"},
    {Splat::kSized, "sized", "as large as the sample's patch of surface appears"},
    {Splat::kNearest, "nearest", "of the nearest surface the sample nearest to the pixel's centre"},
    {Splat::kMean, "mean", "of the nearest surface the mean of what covers the pixel's centre"},
}};

}  // namespace

std::span<const SplatInfo> allSplats() { return kSplats; }

const SplatInfo& infoOf(Splat splat) { return kSplats[static_cast<std::size_t>(splat)]; }

}  // namespace enfilade
