#include "app/view/world_marks.h"

#include <array>
#include <cmath>
#include <set>

namespace enfilade {

namespace {

OverlayColor colorOf(const Portal& portal, PortalId id, const VisibleSet& seen) {
  if (!portal.active) return Theme::kShut;
  for (const VisiblePortal& visible : seen.portals) {
    if (visible.portal == id) return visible.as_image ? Theme::kAsImage : Theme::kAsGeometry;
  }
  return Theme::kUnseen;
}

}  // namespace

WorldMarks::WorldMarks(OverlayPainter& overlay, const Theme& theme, const Camera& camera,
                       const PixelBox& box)
    : overlay_(overlay),
      theme_(theme),
      box_(box),
      clip_from_world_(camera.clipFromWorld()),
      near_(static_cast<double>(camera.near_plane)) {}

glm::vec2 WorldMarks::toPixel(const glm::dvec4& clip) const {
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  return box_.low + glm::vec2(0.5 * (1 + ndc.x), 0.5 * (1 - ndc.y)) * box_.size();
}

void WorldMarks::line(const glm::vec3& from, const glm::vec3& to, float width,
                      const OverlayColor& color) {
  glm::dvec4 a = clip_from_world_ * glm::dvec4(from, 1), b = clip_from_world_ * glm::dvec4(to, 1);
  if (a.w < near_ && b.w < near_) return;
  // What lies behind the eye is cut off at the near plane.
  if (a.w < near_) a = glm::mix(b, a, (b.w - near_) / (b.w - a.w));
  if (b.w < near_) b = glm::mix(a, b, (a.w - near_) / (a.w - b.w));
  overlay_.line(toPixel(a), toPixel(b), width * theme_.scale, color);
}

void WorldMarks::portals(const CellGraph& graph, const VisibleSet& seen) {
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    const Portal& portal = graph.portals[id];
    const OverlayColor color = colorOf(portal, id, seen);
    const float width = color == Theme::kUnseen ? 1.0f : 2.5f;
    for (std::size_t i = 0; i < portal.polygon.size(); ++i) {
      line(portal.polygon[i], portal.polygon[(i + 1) % portal.polygon.size()], width, color);
    }
  }
}

void WorldMarks::names(const CellGraph& graph, const VisibleSet& seen) {
  const auto name = [&](CellId id) {
    const Cell& cell = graph.cells[id];
    if (id == kExterior || cell.bounds.empty()) return;
    const glm::dvec4 clip = clip_from_world_ * glm::dvec4(cell.bounds.center(), 1);
    if (clip.w < near_) return;
    const TextStyle style = theme_.bold();
    const glm::vec2 half(0.5f * overlay_.textWidth(cell.name, style),
                         0.5f * overlay_.lineHeight(style));
    const glm::vec2 at = toPixel(clip), room(4 * theme_.scale, 1 * theme_.scale);
    if (!box_.contains(at)) return;
    overlay_.box({at - half - room, at + half + room}, Theme::kPanel);
    overlay_.text(cell.name, at - half, style);
  };
  std::set<CellId> named;
  for (const VisibleCell& cell : seen.cells) named.insert(cell.cell);
  for (const VisiblePortal& portal : seen.portals) {  // an image shows what is behind it
    named.insert(graph.portals[portal.portal].cellBehind(portal.from_front));
  }
  for (CellId id = 0; seen.cells.empty() && id < graph.cells.size(); ++id) named.insert(id);
  for (const CellId id : named) name(id);
}

void WorldMarks::frustum(const Camera& camera, float far) {
  const glm::vec3 eye = camera.pose.position;
  const glm::mat3 axes(camera.worldFromCamera());
  const float up = far * std::tan(0.5f * camera.vertical_fov), right = up * camera.aspect;
  std::array<glm::vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const float x = i == 0 || i == 3 ? -right : right, y = i < 2 ? -up : up;
    corners[i] = eye + axes * glm::vec3(x, y, -far);
  }
  const OverlayColor color(0.45f, 0.75f, 1, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    line(eye, corners[i], 1.5f, color);
    line(corners[i], corners[(i + 1) % 4], 1.5f, color);
  }
}

}  // namespace enfilade
