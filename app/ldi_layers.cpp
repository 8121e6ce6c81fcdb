#include "app/ldi_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "ibr/image_kinds.h"
#include "ibr/ldi_file.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

Ldi readSide(const House& house, const std::string& folder, PortalId portal, bool from_front) {
  const std::string name = portalImageName(portal, from_front, ldiFileName());
  return decodeLdi(readHouseFile(house, folder, name), folder + "/" + name);
}

/// The pixel of a sample in the image's window.
glm::ivec2 pixelOf(const LdiTile& tile, const LdiSample& s) {
  return {tile.x * kLdiTile + static_cast<int>(xInTile(s)),
          tile.y * kLdiTile + static_cast<int>(yInTile(s))};
}

/// Calls body(sample, pixel, layer) for every sample, the farthest of a pixel first; its layer
/// counts from 1.
template <class Body>
void forEachLayer(const Ldi& ldi, const Body& body) {
  std::array<std::size_t, kLdiTile * kLdiTile> left{};
  for (const LdiTile& tile : ldi.tiles) {
    const auto samples = std::span(ldi.samples).subspan(tile.first, tile.count);
    const auto in_tile = [&](const LdiSample& s) -> std::size_t& {
      return left[static_cast<std::size_t>(yInTile(s)) * kLdiTile +
                  static_cast<std::size_t>(xInTile(s))];
    };
    left.fill(0);
    for (const LdiSample& s : samples) ++in_tile(s);
    for (const LdiSample& s : samples) body(s, pixelOf(tile, s), in_tile(s)--);
  }
}

}  // namespace

std::size_t SideLayers::total() const {
  return std::accumulate(samples.begin(), samples.end(), std::size_t{0});
}

std::vector<SideLayers> countLayers(const House& house, const std::string& folder) {
  std::vector<SideLayers> sides;
  for (PortalId portal = 0; portal < house.graph.portals.size(); ++portal) {
    for (const bool from_front : {true, false}) {
      if (!hasFile(house, portalImageName(portal, from_front, ldiFileName()))) continue;
      sides.push_back(
          {portal, from_front, samplesPerLayer(readSide(house, folder, portal, from_front))});
    }
  }
  return sides;
}

std::vector<std::size_t> samplesInAll(const std::vector<SideLayers>& sides) {
  std::vector<std::size_t> sum;
  for (const SideLayers& side : sides) {
    sum.resize(std::max(sum.size(), side.samples.size()));
    for (std::size_t i = 0; i < side.samples.size(); ++i) sum[i] += side.samples[i];
  }
  return sum;
}

const SideLayers& chooseSide(const std::vector<SideLayers>& sides, int portal,
                             const std::string& side) {
  const SideLayers* most = nullptr;
  for (const SideLayers& candidate : sides) {
    if (portal >= 0 && candidate.portal != static_cast<PortalId>(portal)) continue;
    if (!side.empty() && candidate.from_front != (side == "front")) continue;
    if (most == nullptr || candidate.total() > most->total()) most = &candidate;
  }
  if (most != nullptr) return *most;
  throw Error(ErrorKind::kUsage, portal < 0 ? "--side " + side : fmt::format("--portal {}", portal),
              "no such portal side has a layered depth image; 'enfilade inspect HOUSE --layers "
              "FOLDER' lists those that have");
}

Image layerPicture(const Ldi& ldi, std::size_t layer, const std::string& subject) {
  glm::ivec2 least(std::numeric_limits<int>::max());
  glm::ivec2 greatest(-1);
  forEachLayer(ldi, [&](const LdiSample&, const glm::ivec2& pixel, std::size_t) {
    least = glm::min(least, pixel);
    greatest = glm::max(greatest, pixel);
  });
  Image picture;
  if (greatest.x < 0) return picture;
  const glm::ivec2 size = greatest - least + 1;
  if (std::int64_t{size.x} * size.y > kMostPixels) {
    throw Error(
        ErrorKind::kBadInput, subject,
        fmt::format("is {} x {} pixels wide and high, too much for a picture", size.x, size.y));
  }
  picture.width = size.x;
  picture.height = size.y;
  picture.rgba.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  forEachLayer(ldi, [&](const LdiSample& s, const glm::ivec2& pixel, std::size_t its_layer) {
    if (its_layer != layer) return;
    const glm::ivec2 at = pixel - least;
    std::uint8_t* const rgba =
        &picture.rgba[4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) +
                           static_cast<std::size_t>(at.x))];
    rgba[0] = s.r;
    rgba[1] = s.g;
    rgba[2] = s.b;
    rgba[3] = 255;
  });
  return picture;
}

std::size_t writeLayerPictures(const House& house, const std::string& house_folder,
                               const SideLayers& side, const std::string& folder) {
  const std::string file = portalImageFolder(house_folder, side.portal, side.from_front);
  const Ldi ldi = readSide(house, house_folder, side.portal, side.from_front);
  createFolders(folder);
  for (std::size_t layer = 1; layer <= side.samples.size(); ++layer) {
    writePng(fmt::format("{}/layer-{}.png", folder, layer), layerPicture(ldi, layer, file));
  }
  return side.samples.size();
}

std::string layersText(const std::vector<SideLayers>& sides) {
  const auto line = [](const std::string& name, const std::vector<std::size_t>& samples) {
    const std::size_t sum = std::accumulate(samples.begin(), samples.end(), std::size_t{0});
    std::array<std::size_t, 4> layers{};
    for (std::size_t i = 0; i < samples.size(); ++i)
      layers[std::min<std::size_t>(i, 3)] += samples[i];
    std::string text = fmt::format("  {:<12} {:>10}", name, sum);
    for (const std::size_t count : layers) {
      const double percent =
          sum == 0 ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(sum);
      text += fmt::format(" {:>10} {:>5.1f} %", count, percent);
    }
    return text + fmt::format(" {:>7}\n", samples.size());
  };
  std::string text = fmt::format(
      "samples of the layered depth images by layer\n  {:<12} {:>10} {:>18} {:>18} "
      "{:>18} {:>18} {:>7}\n",
      "portal", "samples", "layer 1", "layer 2", "layer 3", "layers 4+", "layers");
  for (const SideLayers& side : sides) {
    text +=
        line(fmt::format("{} {}", side.portal, side.from_front ? "front" : "back"), side.samples);
  }
  return text + line("all", samplesInAll(sides));
}

}  // namespace enfilade
