#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/image.h"

namespace enfilade {

/// What stands in the pixels that no sample fell into.
enum class Holes : std::uint8_t {
  kNothing,  ///< whatever is drawn there otherwise
  kPersist,  ///< what the warped images of the frame before had there (Rafferty et al. 1998)
  kInpaint   ///< what surrounds the hole, grown inward
};

struct HolesInfo {
  Holes holes;
  const char* name;         ///< on the command line and in reports
  const char* description;  ///< in a few words
};

/// Every way of filling holes, in the order of Holes.
std::span<const HolesInfo> allHoles();

/// Fills the holes (alpha 0) of a warped picture; they have kAlphaOfFilling then.  Keeps working
/// memory between frames.
class HoleFiller {
 public:
  /// Fills the holes of `picture` in columns [spans[y].x, spans[y].y) of rows [top, bottom) by the
  /// pixels of `before` (same size) that are none.
  static void persist(const Image& before, std::span<const glm::ivec2> spans, int top, int bottom,
                      Image& picture) noexcept;

  /// Fills the holes there ring by ring: every pixel of the hole that touches a known one takes the
  /// mean of those known among its eight neighbours, until none is left or `kMostRings` are filled.
  /// No pixel outside the spans is read, so what lies beside a portal does not bleed into it.
  void inpaint(std::span<const glm::ivec2> spans, int top, int bottom, Image& picture);

  static constexpr int kMostRings = 64;

 private:
  std::vector<glm::ivec2> holes_;
  std::vector<std::uint32_t> colors_;  ///< of holes_, once they are known
};

}  // namespace enfilade
