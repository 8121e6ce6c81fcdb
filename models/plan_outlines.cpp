#include "models/plan_outlines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/polygon.h"
#include "scene/error.h"

namespace enfilade {
namespace {

using Stretch = std::vector<std::size_t>;  // half walls in one line, of one thickness

class OutlineTracer {
 public:
  OutlineTracer(const PlanStorey& plan, const PlanAreas& areas, const std::string& subject)
      : plan_(plan), faces_(areas.faces), areas_(areas), subject_(subject) {}

  PlanOutlines run() {
    outlines_.edge_of_half.resize(faces_.halves.size());
    for (std::size_t face = 0; face < faces_.faces.size(); ++face) {
      outlines_.of_face.emplace_back();
      if (areas_.area[face] != kMasonry) trace(face, outlines_.of_face.back());
    }
    return std::move(outlines_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, subject_, reason);
  }

  double halfThickness(std::size_t half) const {
    return 0.5 * plan_.walls[faces_.halves[half].wall].thickness;
  }

  bool sameDirection(std::size_t a, std::size_t b) const {
    return glm::dot(faces_.direction(a), faces_.direction(b)) > 1 - 1e-9;
  }

  bool sameStretch(std::size_t a, std::size_t b) const {
    return sameDirection(a, b) && std::abs(halfThickness(a) - halfThickness(b)) < 1e-9;
  }

  std::vector<Stretch> stretchesOf(std::size_t face) const {
    std::vector<std::size_t> halves = faces_.faces[face];
    // Begin at a true corner, so that no stretch is cut by the beginning of the list.
    const std::size_t n = halves.size();
    std::size_t corner = 0;
    while (corner + 1 < n && sameStretch(halves[(corner + n - 1) % n], halves[corner])) ++corner;
    std::rotate(halves.begin(), halves.begin() + static_cast<std::ptrdiff_t>(corner), halves.end());
    std::vector<Stretch> stretches;
    for (const std::size_t half : halves) {
      if (stretches.empty() || !sameStretch(stretches.back().back(), half))
        stretches.emplace_back();
      stretches.back().push_back(half);
    }
    return stretches;
  }

  void trace(std::size_t face, Outline& outline) {
    const auto stretches = stretchesOf(face);
    const std::size_t n = stretches.size();
    for (std::size_t i = 0; i < n; ++i)
      addStretch(stretches[(i + n - 1) % n].back(), stretches[i], stretches[(i + 1) % n].front(),
                 outline);
    if (signedArea(outline.corners()) * signedArea(faces_.polygon(face)) <= 0)
      fail(fmt::format("{}: its walls are so thick that nothing is left",
                       areaName(plan_, areas_.area[face])));
  }

  void addStretch(std::size_t before, const Stretch& stretch, std::size_t after, Outline& outline) {
    const glm::dvec2 d = faces_.direction(stretch.front());
    LayoutEdge edge;
    edge.inward = leftOf(d);
    edge.from = cornerOf(before, stretch.front(), stretch.front());
    edge.to = cornerOf(stretch.back(), after, stretch.front());
    if (glm::dot(edge.to - edge.from, d) < 0.01)
      fail(fmt::format("walls[{}]: the walls beside it leave nothing of it",
                       faces_.halves[stretch.front()].wall));
    for (const std::size_t half : stretch) outlines_.edge_of_half[half] = outline.edges.size();
    outline.edges.push_back(edge);
    // Walls of other thickness in one line: a small step joins their faces.
    if (sameDirection(stretch.back(), after)) {
      LayoutEdge step;
      step.from = edge.to;
      step.to = cornerOf(stretch.back(), after, after);
      step.inward = leftOf(glm::normalize(step.to - step.from));
      outline.edges.push_back(step);
    }
  }

  /// The corner between halves `a` and `b` on the face of `own`, one of the two.
  glm::dvec2 cornerOf(std::size_t a, std::size_t b, std::size_t own) const {
    const glm::dvec2 at = faces_.start(b);
    if (sameDirection(a, b)) return at + leftOf(faces_.direction(own)) * halfThickness(own);
    return movedCorner(at, faces_.direction(a), halfThickness(a), faces_.direction(b),
                       halfThickness(b));
  }

  const PlanStorey& plan_;
  const PlanarFaces& faces_;
  const PlanAreas& areas_;
  const std::string& subject_;
  PlanOutlines outlines_;
};

}  // namespace

PlanOutlines traceOutlines(const PlanStorey& plan, const PlanAreas& areas,
                           const std::string& subject) {
  return OutlineTracer(plan, areas, subject).run();
}

}  // namespace enfilade
