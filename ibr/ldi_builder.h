#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ibr/capture_samples.h"
#include "ibr/ldi.h"

namespace enfilade {

/// How captures become a layered depth image.
struct LdiRules {
  float depth_threshold = 1.0f;  ///< [pixels] two samples show one surface if taking one for the
                                 ///< other moves it by no more than this, seen from one image plane
                                 ///< distance beside the central viewpoint: |Δδ| ≤ k·p/n
  float half_width = 16.0f;      ///< [half widths and heights of the central image] [≥ 1]
};

/// The greatest difference of disparity in `central` between two samples of one surface.
float disparityThreshold(const PlanarCamera& central, float depth_threshold_pixels) noexcept;

/// Builds a layered depth image by warping captures into the central view.
///
/// - The central image is layer one: never displaced (nothing comes before it) and never removed.
/// - A sample of another capture is new where its pixel is empty or holds nothing of similar depth.
/// - Where it meets a sample of similar depth, the one that saw the smaller patch of surface stays.
/// - Two samples of the same capture both stay.
/// - The layers of a pixel are in depth order.
/// - Beyond the paper: what stays covers as much as what gives way to it, up to kLeastCover pixels,
///   so that no crack opens between the samples of two captures.
///
/// The same LDI for the same captures in the same order.
/// Source: Rafferty et al. 1998, sec. 3.2.
class LdiBuilder {
 public:
  static constexpr float kLeastCover = 0.7f;  ///< [pixels] of the central image, across and down

  /// `central`: the camera of the central capture; the LDI has its rays and a window of its own.
  LdiBuilder(const PlanarCamera& central, const LdiRules& rules);

  /// Inserts a capture.  The first one must be the central one.
  void insert(const CaptureSamples& capture);

  /// The layered depth image of what was inserted.
  Ldi finish() const;

 private:
  /// What decides whether a sample stays.
  struct Layer {
    float disparity;        ///< in the central view
    float area;             ///< of the patch of surface that its pixel saw [m²]
    std::uint32_t capture;  ///< its number
    std::uint32_t farther;  ///< the next layer of the pixel
  };
  /// What else there is to a sample.
  struct Look {
    float x, y;          ///< pixels from the tile's corner
    float across, down;  ///< size of its patch in the central view [pixels]
    std::uint8_t r, g, b;

    void coverAlso(const Look& other) noexcept;
  };
  /// All layers of a tile stand together: a capture fills tile after tile, so what it needs next is
  /// mostly in the cache.
  struct Tile {
    int x, y;                                                ///< from the central image's corner
    std::array<std::uint32_t, kLdiTile * kLdiTile> nearest;  ///< layer of each pixel
    std::vector<Layer> layers;
    std::vector<Look> looks;  ///< one a layer
    std::uint32_t free;       ///< first of the layers that were removed
  };

  Tile* tileAt(float x, float y);
  bool meets(const Layer& a, const Layer& b) const noexcept;
  bool stays(Tile& tile, std::uint32_t nearest, const Layer& layer,
             const Look& look) const noexcept;
  void removeThoseItMeets(Tile& tile, std::uint32_t& nearest, const Layer& layer,
                          Look& look) const noexcept;
  void place(Tile& tile, std::uint32_t& nearest, Layer layer, Look look) const;

  PlanarCamera central_;
  float threshold_;
  glm::ivec2 least_{0}, tiles_across_{0};  ///< of the tiles that may be used
  std::vector<std::uint32_t> tile_at_;     ///< index in tiles_, or none
  std::vector<Tile> tiles_;
  std::uint32_t captures_ = 0;
};

}  // namespace enfilade
