#pragma once

#include "render/overlay_painter.h"

namespace enfilade {

/// Colours and measures of the window's panels; `scale`: pixels for one of an ordinary screen.
struct Theme {
  float scale = 1;

  static constexpr OverlayColor kPanel{0.07f, 0.08f, 0.10f, 0.78f};
  static constexpr OverlayColor kInk{0.95f, 0.96f, 0.97f, 1};
  static constexpr OverlayColor kFaint{0.68f, 0.72f, 0.77f, 1};
  static constexpr OverlayColor kAccent{0.98f, 0.72f, 0.25f, 1};
  static constexpr OverlayColor kHover{1, 1, 1, 0.14f};

  // A portal by what it shows; the plan and the view agree.
  static constexpr OverlayColor kAsImage{1.0f, 0.62f, 0.15f, 1};
  static constexpr OverlayColor kAsGeometry{0.35f, 0.92f, 0.45f, 1};
  static constexpr OverlayColor kShut{0.95f, 0.30f, 0.30f, 1};
  static constexpr OverlayColor kUnseen{0.62f, 0.66f, 0.72f, 0.55f};

  float margin() const { return 12 * scale; }
  float padding() const { return 10 * scale; }
  TextStyle text(const OverlayColor& color = kInk) const {
    return {15 * scale, FontFace::kRegular, color};
  }
  TextStyle small(const OverlayColor& color = kFaint) const {
    return {13 * scale, FontFace::kRegular, color};
  }
  TextStyle bold(const OverlayColor& color = kInk) const {
    return {15 * scale, FontFace::kBold, color};
  }
  TextStyle title(const OverlayColor& color = kInk) const {
    return {20 * scale, FontFace::kBold, color};
  }
};

}  // namespace enfilade
