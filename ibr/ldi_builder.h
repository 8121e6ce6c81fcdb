#pragma once

#include <cstdint>
#include <vector>

#include "ibr/capture_samples.h"
#include "ibr/ldi.h"
#include "ibr/warp_transform.h"

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
///
/// The same LDI for the same captures in the same order.
/// Source: Rafferty et al. 1998, sec. 3.2.
class LdiBuilder {
 public:
  /// `central`: the camera of the central capture; the LDI has its rays and a window of its own.
  LdiBuilder(const PlanarCamera& central, const LdiRules& rules);

  /// Inserts a capture.  The first one must be the central one.
  void insert(const CaptureSamples& capture);

  /// The layered depth image of what was inserted.
  Ldi finish() const;

 private:
  struct Node {
    float x, y;          ///< pixels of the central image
    float disparity;     ///< in the central view
    float area;          ///< of the patch of surface that its pixel saw [m²]
    float across, down;  ///< size of that patch in the central view [pixels]
    std::uint8_t r, g, b;
    std::uint32_t capture;
    std::uint32_t next;  ///< of the same pixel, farther
  };
  struct Tile {
    int x, y;                          ///< in tiles from the central image's corner
    std::vector<std::uint32_t> heads;  ///< nearest node of each pixel
  };

  std::uint32_t* headAt(float x, float y);
  bool meets(const Node& a, const Node& b) const noexcept;
  void place(const Node& node);
  std::vector<const Tile*> tilesInUse() const;
  void appendSamples(const Tile& tile, Ldi& ldi) const;

  PlanarCamera central_;
  float threshold_;
  glm::ivec2 least_{0}, tiles_across_{0};  ///< of the tiles that may be used
  std::vector<std::uint32_t> tile_at_;     ///< index in tiles_, or none
  std::vector<Tile> tiles_;
  std::vector<Node> nodes_;
  std::uint32_t captures_ = 0;
};

}  // namespace enfilade
