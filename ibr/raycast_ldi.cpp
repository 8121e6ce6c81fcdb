// Rafferty, Aliaga, Popescu & Lastra, Images for Accelerating Architectural Walkthroughs, 1998,
// sec. 3.2, Figure 4a.
#include "ibr/raycast_ldi.h"

#include <map>
#include <set>
#include <utility>

#include "ibr/ldi_builder.h"
#include "ibr/tile_caster.h"
#include "render/parallel_for.h"

namespace enfilade {
namespace {

using TileAt = std::pair<int, int>;  // row, column

/// The objects that some viewpoint may see: one flag an object.
std::vector<std::uint8_t> candidatesOf(const std::vector<PlanarCamera>& cameras,
                                       const ObjectsInView& objects, double far_depth) {
  std::vector<std::uint8_t> flags;
  for (const PlanarCamera& camera : cameras) {
    for (const std::uint32_t object : objects(viewOf(camera, far_depth))) {
      if (flags.size() <= object) flags.resize(std::size_t{object} + 1);
      flags[object] = 1;
    }
  }
  return flags;
}

/// Tiles to be cast, and those that were, which grow from the central image outward.
class GrowingWindow {
 public:
  GrowingWindow(const PlanarCamera& central, float half_width)
      : across_(tileRange(central.width, half_width)),
        down_(tileRange(central.height, half_width)) {
    for (int y = 0; y * kLdiTile < central.height; ++y) {
      for (int x = 0; x * kLdiTile < central.width; ++x) ask({y, x});
    }
  }

  /// The tiles to cast next, each asked for once.
  std::vector<TileAt> next() { return std::exchange(asked_, {}); }

  /// A tile was cast: where it shows something its neighbours may too.
  void store(const TileAt& tile, std::vector<LooseSample> samples) {
    if (samples.empty()) return;
    tiles_[tile] = std::move(samples);
    for (int y = tile.first - 1; y <= tile.first + 1; ++y) {
      for (int x = tile.second - 1; x <= tile.second + 1; ++x) ask({y, x});
    }
  }

  Ldi pack(const PlanarCamera& central) const {
    LdiPacking packing(central);
    for (const auto& [tile, samples] : tiles_) packing.add(tile.second, tile.first, samples);
    return packing.finish();
  }

 private:
  void ask(const TileAt& tile) {
    const auto within = [](int at, const glm::ivec2& range) {
      return at >= range[0] && at < range[0] + range[1];
    };
    if (within(tile.first, down_) && within(tile.second, across_) && known_.insert(tile).second) {
      asked_.push_back(tile);
    }
  }

  glm::ivec2 across_, down_;  ///< first and number
  std::set<TileAt> known_;
  std::vector<TileAt> asked_;
  std::map<TileAt, std::vector<LooseSample>> tiles_;  ///< by row, then by column
};

}  // namespace

Ldi raycastLdi(const RayCaster& caster, const Portal& portal, bool from_front, float eye_y,
               const ImageParameters& parameters, const ObjectsInView& objects, double far_depth) {
  const auto viewpoints = captureViewpoints(portal, from_front, eye_y, parameters);
  if (viewpoints.empty()) return {};
  std::vector<PlanarCamera> cameras;
  for (const glm::dvec3& at : viewpoints) {
    cameras.push_back(portalCamera(portal, from_front, at, parameters));
  }
  const PlanarCamera& central = cameras.front();
  const SightLines sight_lines(caster, central, viewpoints, portal, from_front, parameters,
                               far_depth);
  const TileCasting casting{caster,
                            central,
                            sight_lines,
                            candidatesOf(cameras, objects, far_depth),
                            parameters.rays,
                            disparityThreshold(central, parameters.depth_threshold),
                            far_depth / imagePlaneDistance(central)};
  GrowingWindow window(central, parameters.ldi_half_width);
  for (auto tiles = window.next(); !tiles.empty(); tiles = window.next()) {
    std::vector<std::vector<LooseSample>> samples(tiles.size());
    parallelFor(tiles.size(), [&](std::size_t i) {
      samples[i] = TileCaster(casting).cast(tiles[i].second, tiles[i].first);
    });
    for (std::size_t i = 0; i < tiles.size(); ++i) window.store(tiles[i], std::move(samples[i]));
  }
  return window.pack(central);
}

}  // namespace enfilade
