#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "ibr/region_clip.h"

namespace enfilade {

/// A line of the desired picture: a·x + b·y + c ≥ 0 on its one side, a² + b² = 1.
struct CutLine {
  double a = 0, b = 0, c = 0;
};

inline constexpr std::size_t kMostFragments = 64;
inline constexpr std::size_t kMostCuts = 7;  ///< of one fragment: log₂ kMostFragments, and one

/// A part of the desired picture that one thread warps: what lies on the inner side of some lines
/// through the epipole.
struct Fragment {
  std::array<CutLine, kMostCuts> lines{};
  std::array<bool, kMostCuts> flipped{};  ///< the inner side is where the line is < 0
  std::size_t count = 0;

  /// The columns of `span` in row y whose pixel centres lie in the fragment: no pixel is in two
  /// fragments of one cutting, and every pixel in one.
  glm::ivec2 columns(int y, glm::ivec2 span) const noexcept;

  /// Whether any pixel centre in `box`, or a pixel beside it, may lie in the fragment:
  /// conservative.
  bool mayTouch(const ScreenBox& box) const noexcept;
};

/// Where a tile's samples fall, about, and how many they are.
struct TileWeight {
  glm::vec2 at{0};
  float weight = 0;
};

/// Cuts the desired picture along lines through `epipole` (the reference's eye as the desired image
/// sees it, homogeneous pixels), which are the pictures of lines through the desired eye's picture
/// in the reference, into at most `wanted` fragments with about as many samples each.  `tiles` are
/// reordered.  Returns how many of `out` were set, 1 or more.
/// Source: Rafferty et al. 1998, sec. 3.1, where the fragments have equal areas.
std::size_t cutIntoFragments(const glm::dvec3& epipole, std::span<TileWeight> tiles, int wanted,
                             std::span<Fragment, kMostFragments> out) noexcept;

}  // namespace enfilade
