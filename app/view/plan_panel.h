#pragma once

#include <optional>
#include <vector>

#include "app/plan_slice.h"
#include "app/view/theme.h"
#include "scene/camera.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// What the plan shows besides the house.
struct PlanMarks {
  Camera camera;                                 ///< where one stands
  const VisibleSet* seen = nullptr;              ///< by the frame
  std::optional<Camera> frozen;                  ///< the camera that culling is frozen for
  std::optional<glm::vec2> pointer;              ///< of the mouse [pixels]
  const std::vector<glm::vec3>* path = nullptr;  ///< that is recorded or played
};

/// The house's plan, storey by storey, in a corner of the window.
class PlanPanel {
 public:
  /// `house` must outlive it.
  explicit PlanPanel(const House& house);

  /// Draws the storey of the eye, or the one that was turned to, with its lower right corner at
  /// `corner`.
  void draw(OverlayPainter& overlay, const Theme& theme, const glm::vec2& corner,
            const PlanMarks& marks);

  /// Turns to the next storey until the eye changes its own.
  void turnPage();

  /// Where `pixel` means in the storey that was drawn last, at eye height; nothing outside the
  /// plan.
  std::optional<glm::vec3> placeAt(const glm::vec2& pixel) const;

  /// Whether `pixel` is of the panel that was drawn last.
  bool covers(const glm::vec2& pixel) const { return panel_.contains(pixel); }

 private:
  struct Page {
    PlanSlice slice;
    Image picture;                   // of the storey that is drawn
    std::vector<std::uint8_t> seen;  // one a cell: how the picture shows them
    glm::ivec2 size{0};
  };

  std::size_t storeyOf(float y) const;
  const Page& page(std::size_t storey, const glm::ivec2& size, const VisibleSet* seen);
  void paint(Page& page, const glm::ivec2& size) const;
  glm::vec2 toPanel(const glm::vec3& p) const;
  void drawPortals(OverlayPainter& overlay, const Theme& theme, const VisibleSet* seen) const;
  void drawCamera(OverlayPainter& overlay, const Theme& theme, const Camera& camera,
                  const OverlayColor& color) const;
  bool standsOn(std::size_t storey, float y) const;

  const House& house_;
  glm::vec2 low_{0}, high_{1};  // x and z that the plan shows [m]
  std::vector<Page> pages_;     // one a storey, made when first drawn
  std::size_t storey_ = 0;      // drawn last
  std::size_t eye_storey_ = 0;
  std::size_t turned_ = 0;  // pages on from the eye's own
  PixelBox panel_, map_;    // drawn last
  bool changed_ = false;    // the page's picture
};

}  // namespace enfilade
