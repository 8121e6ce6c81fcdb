#include "app/view/pixel_marks.h"

#include <array>

namespace enfilade {

namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr std::array<Rgba, 6> kTints = {{{255, 140, 0, 105},
                                         {0, 160, 255, 105},
                                         {60, 200, 80, 105},
                                         {220, 60, 200, 105},
                                         {240, 220, 40, 105},
                                         {120, 100, 255, 105}}};
constexpr Rgba kMissing = {255, 0, 255, 255};

}  // namespace

void markPixels(FramePainter& painter, bool tint, bool uncovered, Image& out) {
  PortalMask mask;
  painter.readPortalMask(mask);
  std::vector<std::uint8_t> missing;
  if (uncovered) painter.readUncovered(mask, missing);
  out.width = painter.width();
  out.height = painter.height();
  out.rgba.assign(4 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height),
                  0);
  for (std::size_t p = 0; p < mask.of_pixel.size(); ++p) {
    const std::size_t image = mask.of_pixel[p];
    if (image == 0) continue;
    const std::size_t side =
        sideIndex(mask.sides[image - 1].portal, mask.sides[image - 1].from_front);
    Rgba color{};
    if (tint) color = kTints[side % kTints.size()];
    if (uncovered && missing[p] != 0) color = kMissing;
    std::copy(color.begin(), color.end(), &out.rgba[4 * p]);
  }
}

}  // namespace enfilade
