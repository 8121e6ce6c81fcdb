#include "preprocess/fit_portal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "preprocess/section.h"

namespace enfilade {

namespace {

constexpr float kSlide = 0.7f;       // [m] either way, in search of the smallest section
constexpr float kMostMoved = 0.35f;  // [m] from where the voxels met
constexpr float kAround = 0.4f;      // [m] about an interface, where its opening's edges are sought
constexpr float kFarAround = 1.6f;   // [m] likewise, where only a part of the opening has met
constexpr float kPlateau = 1.12f;    // times the smallest section: still inside the wall
constexpr float kRagged = 2.0f;      // [pixels] about its outline: likewise
constexpr float kLevel = 0.75f;      // |normal.y| of horizontal portals
constexpr int kMostPixels = 600;     // along a window's side

/// Where along the normal the section is smallest.
struct Plateau {
  float first = 0, last = 0;  ///< [m]
  float at = 0;               ///< [m] the middle
  int count = 0;              ///< [pixels]
  bool ends = false;          ///< it ends within the slide on both sides
};

glm::mat3 axesFor(const glm::vec3& normal, float angle) {
  const glm::vec3 wall(std::sin(angle), 0.0f, std::cos(angle));
  if (std::abs(normal.y) > 0.5f) return {wall, glm::cross(normal, wall), normal};
  const glm::vec3 up(0, 1, 0);
  return {glm::cross(up, normal), up, normal};
}

/// Frames to try: square to the walls near by; then, or without walls, to the interface.
std::vector<glm::mat3> framesFor(const WallFaces& walls, const Interface& interface) {
  const float angle = walls.wallAngle(interface.bounds.grown(0.6f));
  const glm::vec3& n = interface.normal;
  if (std::abs(n.y) > kLevel) {
    return {axesFor({0.0f, n.y > 0 ? 1.0f : -1.0f, 0.0f}, std::max(angle, 0.0f))};
  }
  const glm::vec3 flat = glm::normalize(glm::vec3(n.x, 0.0f, n.z));
  if (angle < 0) return {axesFor(flat, 0.0f)};
  std::vector<glm::mat3> frames;
  glm::vec3 wall(std::sin(angle), 0.0f, std::cos(angle));
  for (int i = 0; i < 4; ++i) {
    if (glm::dot(wall, flat) > 0.5f) frames.push_back(axesFor(wall, 0.0f));
    wall = {wall.z, 0.0f, -wall.x};
  }
  std::stable_sort(frames.begin(), frames.end(), [&](const glm::mat3& a, const glm::mat3& b) {
    return glm::dot(a[2], flat) > glm::dot(b[2], flat) + 1e-4f;
  });
  frames.push_back(axesFor(flat, 0.0f));  // walls that curve have many directions
  return frames;
}

SectionWindow windowFor(const VoxelGrid& voxels, const Interface& interface, const glm::mat3& axes,
                        float around) {
  SectionWindow window;
  window.center = interface.centroid;
  window.axes = axes;
  glm::vec2 lo(1e9f), hi(-1e9f);
  for (const glm::vec3& face : interface.faces) {
    const glm::vec2 p(glm::transpose(axes) * (face - interface.centroid));
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  window.lo = lo - around;
  window.footed = std::abs(axes[2].y) < 0.5f && std::isfinite(interface.foot);
  if (window.footed) window.lo.y = interface.foot - interface.centroid.y;
  const glm::vec2 size = hi + around - window.lo;
  window.pixel = std::max(0.5f * voxels.voxel, std::max(size.x, size.y) / float(kMostPixels));
  window.size_u = static_cast<int>(std::ceil(size.x / window.pixel));
  window.size_v = static_cast<int>(std::ceil(size.y / window.pixel));
  return window;
}

std::optional<Plateau> findPlateau(const VoxelGrid& voxels, const SectionWindow& window,
                                   const Interface& interface) {
  const float step = 0.5f * voxels.voxel;
  const int reach = static_cast<int>(kSlide / step);
  std::vector<int> counts;  // −1: open, or nothing free
  int best = -1;
  for (int i = -reach; i <= reach; ++i) {
    const Section section = sectionAt(voxels, window, interface.faces, float(i) * step);
    counts.push_back(section.open || section.count == 0 ? -1 : section.count);
    const int here = static_cast<int>(counts.size()) - 1;
    if (counts.back() < 0) continue;
    const bool nearer = best >= 0 && counts.back() == counts[std::size_t(best)] &&
                        std::abs(i) < std::abs(best - reach);
    if (best < 0 || counts.back() < counts[std::size_t(best)] || nearer) best = here;
  }
  if (best < 0) return std::nullopt;
  // A turned wall's voxels step in and out by one along the opening's edges.
  const float fewest = float(counts[std::size_t(best)]);
  const float limit = std::max(kPlateau * fewest, fewest + kRagged * 4 * std::sqrt(fewest));
  const auto in = [&](int i) {
    return i >= 0 && i < int(counts.size()) && counts[std::size_t(i)] > 0 &&
           float(counts[std::size_t(i)]) <= limit;
  };
  int first = best, last = best;
  while (in(first - 1)) --first;
  while (in(last + 1)) ++last;
  Plateau plateau;
  plateau.first = float(first - reach) * step;
  plateau.last = float(last - reach) * step;
  plateau.at = 0.5f * (plateau.first + plateau.last);
  plateau.count = counts[std::size_t(best)];
  plateau.ends = first > 0 && last + 1 < int(counts.size());
  return plateau;
}

/// Of the planes across `axis` with lo ≤ offset ≤ hi in `box`, the one with the most triangles.
std::optional<float> bestFace(const WallFaces& walls, TurnedBox box, int axis, float lo, float hi,
                              float least_area) {
  box.lo[axis] = lo;
  box.hi[axis] = hi;
  std::optional<float> best;
  float most = least_area;
  for (const WallFaces::Face& face : walls.facesAcross(box, axis)) {
    if (face.area > most) most = face.area, best = face.offset;
  }
  return best;
}

struct Extent {
  glm::vec2 lo{0}, hi{0};  ///< [m] along u and v, from the window's centre
};

Extent extentOf(const SectionWindow& window, const Section& section) {
  return {window.lo + glm::vec2(section.first) * window.pixel,
          window.lo + glm::vec2(section.end) * window.pixel};
}

/// Midway between the wall's faces at the ends of the plateau; of several, the pair whose smaller
/// one is largest.  A sheet without thickness is both.
std::optional<float> snapPlane(const WallFaces& walls, const SectionWindow& window,
                               const Extent& extent, const Plateau& plateau, float voxel) {
  constexpr float kBeside = 0.3f, kLeastArea = 0.02f, kThinnest = 0.01f;
  const float within = 1.3f * voxel, beyond = voxel;
  const TurnedBox box{window.center, window.axes,
                      glm::vec3(extent.lo - kBeside, plateau.first - beyond),
                      glm::vec3(extent.hi + kBeside, plateau.last + beyond)};
  const auto faces = walls.facesAcross(box, 2);
  std::optional<float> best, sheet;
  float most = kLeastArea, most_of_sheet = kLeastArea;
  for (const WallFaces::Face& lo : faces) {
    if (lo.offset > plateau.first + within) continue;
    if (lo.offset >= plateau.last - within && lo.area > most_of_sheet) {
      most_of_sheet = lo.area;
      sheet = lo.offset;
    }
    for (const WallFaces::Face& hi : faces) {
      if (hi.offset < plateau.last - within || hi.offset < lo.offset + kThinnest) continue;
      if (std::min(lo.area, hi.area) <= most) continue;
      most = std::min(lo.area, hi.area);
      best = 0.5f * (lo.offset + hi.offset);
    }
  }
  return best ? best : sheet;
}

/// Moves the edges of a section outward onto the planes that bound the opening.
int snapEdges(const WallFaces& walls, const SectionWindow& window, float n, float voxel,
              Extent& extent) {
  constexpr float kThickness = 0.1f;
  const TurnedBox box{window.center, window.axes, glm::vec3(extent.lo, n - kThickness),
                      glm::vec3(extent.hi, n + kThickness)};
  const float beyond = 1.7f * voxel, within = 0.15f * voxel;
  int snapped = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const float length = extent.hi[1 - axis] - extent.lo[1 - axis];
    const float least = 0.1f * length * kThickness;
    const auto lo = bestFace(walls, box, axis, box.lo[axis] - beyond, box.lo[axis] + within, least);
    const auto hi = bestFace(walls, box, axis, box.hi[axis] - within, box.hi[axis] + beyond, least);
    extent.lo[axis] = lo.value_or(box.lo[axis] - 0.5f * voxel);
    extent.hi[axis] = hi.value_or(box.hi[axis] + 0.5f * voxel);
    snapped += lo.has_value() + hi.has_value();
  }
  return snapped;
}

FittedPortal rectangle(const SectionWindow& window, const Extent& extent, float n) {
  FittedPortal portal;
  portal.center = window.center + window.axes * glm::vec3(0.5f * (extent.lo + extent.hi), n);
  portal.axes = window.axes;
  portal.half = 0.5f * (extent.hi - extent.lo);
  return portal;
}

/// The interface's own extent.
FittedPortal rawPortal(const VoxelGrid& voxels, const SectionWindow& window) {
  const glm::vec2 size = glm::vec2(window.size_u, window.size_v) * window.pixel;
  const glm::vec2 trim(kAround - 0.5f * voxels.voxel);
  glm::vec2 lo = window.lo + trim;
  if (window.footed) lo.y = window.lo.y;
  return rectangle(window, {lo, window.lo + size - trim}, 0.0f);
}

std::optional<FittedPortal> fitInFrame(const VoxelGrid& voxels, const WallFaces& walls,
                                       const Interface& interface, const SectionWindow& window,
                                       const Plateau& plateau) {
  Section section = sectionAt(voxels, window, interface.faces, plateau.at);
  float n = plateau.at;
  bool plane_snapped = false;
  if (plateau.ends && section.count > 0 && !section.open) {
    if (const auto snapped =
            snapPlane(walls, window, extentOf(window, section), plateau, voxels.voxel)) {
      const Section there = sectionAt(voxels, window, interface.faces, *snapped);
      if (there.count > 0 && !there.open && float(there.count) < 1.3f * float(plateau.count) + 2) {
        section = there;
        n = *snapped;
        plane_snapped = true;
      }
    }
  }
  if (section.count == 0 || section.open || std::abs(n) > kMostMoved) return std::nullopt;
  Extent extent = extentOf(window, section);
  const int edges = snapEdges(walls, window, n, voxels.voxel, extent);
  FittedPortal portal = rectangle(window, extent, n);
  portal.fitted = true;
  portal.plane_snapped = plane_snapped;
  portal.edges_snapped = edges;
  return portal;
}

}  // namespace

std::vector<glm::vec3> FittedPortal::polygon() const {
  const glm::vec3 u = axes[0] * half.x, v = axes[1] * half.y;
  return {center - u - v, center + u - v, center + u + v, center - u + v};
}

FittedPortal fitPortal(const VoxelGrid& voxels, const WallFaces& walls,
                       const Interface& interface) {
  const auto frames = framesFor(walls, interface);
  for (const float around : {kAround, kFarAround}) {
    std::optional<FittedPortal> best;
    float smallest = 0;
    for (const glm::mat3& axes : frames) {
      const SectionWindow window = windowFor(voxels, interface, axes, around);
      const auto plateau = findPlateau(voxels, window, interface);
      if (!plateau) continue;
      const auto portal = fitInFrame(voxels, walls, interface, window, *plateau);
      const float area = float(plateau->count) * window.pixel * window.pixel;
      if (portal && (!best || area < 0.9f * smallest)) best = portal, smallest = area;
    }
    if (best) return *best;
  }
  return rawPortal(voxels, windowFor(voxels, interface, frames.front(), kAround));
}

}  // namespace enfilade
