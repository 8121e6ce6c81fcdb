#pragma once

#include <algorithm>
#include <span>

#include "ibr/ldi.h"
#include "ibr/warp_transform.h"

namespace enfilade {

/// The order in which the samples of a reference image must be drawn over each other so that the
/// nearest stays, for a desired eye: the eye's picture in the reference image divides it into 4, 2
/// or 1 sheets; toward that point where the eye stands before the reference's, away from it where
/// it stands behind.
/// Source: McMillan, A List-Priority Rendering Algorithm, 1995; Rafferty et al. 1998, sec. 3.1.
struct SheetOrder {
  int column = 0;      ///< the tile with the eye's picture, or the nearest place beside the image:
  int row = 0;         ///< −1 … number of tiles
  bool toward = true;  ///< draw toward that tile; otherwise away from it
};

/// The order for an eye at `eye` over the tiles of an image of this camera.
SheetOrder sheetOrder(const PlanarCamera& reference, const glm::dvec3& eye);

/// How many sheets that is: 4, 2 or 1.
int sheetCount(const SheetOrder& order, const PlanarCamera& reference);

/// Calls visit(i) for i in [first, beyond) around `middle`, whose keys increase with i: toward the
/// middle from both ends, or away from it.
template <class KeyOf, class Visit>
void visitAround(std::size_t first, std::size_t beyond, int middle, bool toward, KeyOf&& key_of,
                 Visit&& visit) {
  std::size_t at = first;  // the first whose key is not below the middle
  for (std::size_t count = beyond - first; count > 0;) {
    const std::size_t half = count / 2;
    if (key_of(at + half) < middle) {
      at += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  if (toward) {
    for (std::size_t i = first; i < at; ++i) {
      visit(i);
    }
    for (std::size_t i = beyond; i > at; --i) {
      visit(i - 1);
    }
  } else {
    for (std::size_t i = at; i < beyond; ++i) {
      visit(i);
    }
    for (std::size_t i = at; i > first; --i) {
      visit(i - 1);
    }
  }
}

/// Calls visit(tile) for every tile of `ldi`, in occlusion-compatible order.  Going through whole
/// tiles is enough: of two samples on one line through the eye's picture the one in the tile that
/// comes later must be drawn later, and within a tile the samples stand farthest first, which is
/// right for an eye on the near side of the image plane.
template <class Visit>
void visitInSheets(const Ldi& ldi, const SheetOrder& order, Visit&& visit) {
  if (ldi.tiles.empty()) {
    return;
  }
  visitAround(
      0, ldi.row_tiles.size() - 1, order.row, order.toward,
      [](std::size_t row) { return static_cast<int>(row); },
      [&](std::size_t row) {
        visitAround(
            ldi.row_tiles[row], ldi.row_tiles[row + 1], order.column, order.toward,
            [&](std::size_t tile) { return int{ldi.tiles[tile].x}; },
            [&](std::size_t tile) { visit(ldi.tiles[tile]); });
      });
}

}  // namespace enfilade
