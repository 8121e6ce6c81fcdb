#include "models/planar_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "models/polygon.h"
#include "scene/error.h"

namespace enfilade {
namespace {

constexpr double kSnap = 1e-3;  // points nearer than this are one [m]
// Each is looked for among all others: a storey of more would take long.
constexpr std::size_t kMostWalls = 512, kMostJunctions = 2048;

[[noreturn]] void fail(const std::string& subject, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, subject, reason);
}

class Tracer {
 public:
  Tracer(const std::vector<PlanWall>& walls, const std::string& subject)
      : walls_(walls), subject_(subject) {}

  PlanarFaces run() {
    if (walls_.size() > kMostWalls)
      fail(subject_,
           fmt::format("has {} walls in a storey; {} at most", walls_.size(), kMostWalls));
    for (std::size_t w = 0; w < walls_.size(); ++w) splitWall(w);
    linkHalves();
    traceFaces();
    return std::move(result_);
  }

 private:
  std::size_t junctionAt(const glm::dvec2& p) {
    auto& junctions = result_.junctions;
    for (std::size_t i = 0; i < junctions.size(); ++i)
      if (glm::distance(junctions[i], p) < kSnap) return i;
    if (junctions.size() == kMostJunctions)
      fail(subject_, fmt::format("its walls meet in over {} places", kMostJunctions));
    junctions.push_back(p);
    return junctions.size() - 1;
  }

  /// Where the other wall meets this one, as distances along this one.
  void addMeetings(std::size_t w, std::size_t other, std::vector<double>& along) const {
    const glm::dvec2 a = walls_[w].from, b = walls_[other].from;
    const double length = glm::distance(a, walls_[w].to);
    const glm::dvec2 u = (walls_[w].to - a) / length, v = walls_[other].to - b;
    for (const glm::dvec2& end : {b, walls_[other].to}) {
      const double t = glm::dot(end - a, u);
      if (std::abs(planCross(u, end - a)) < kSnap && t > -kSnap && t < length + kSnap)
        along.push_back(t);
    }
    const double det = planCross(u, v);
    if (std::abs(det) < 1e-9) return;
    const double t = planCross(b - a, v) / det, s = planCross(b - a, u) / det;
    if (t > 0 && t < length && s > 0 && s < 1) along.push_back(t);
  }

  void splitWall(std::size_t w) {
    const double length = glm::distance(walls_[w].from, walls_[w].to);
    std::vector<double> along{0, length};
    for (std::size_t other = 0; other < walls_.size(); ++other)
      if (other != w) addMeetings(w, other, along);
    std::sort(along.begin(), along.end());
    const glm::dvec2 u = (walls_[w].to - walls_[w].from) / length;
    std::size_t last = junctionAt(walls_[w].from);
    for (const double t : along) {
      const std::size_t next = junctionAt(walls_[w].from + u * std::clamp(t, 0.0, length));
      if (next != last) addHalves(last, next, w);
      last = next;
    }
  }

  void addHalves(std::size_t a, std::size_t b, std::size_t wall) {
    const auto [place, fresh] = pairs_.try_emplace(std::minmax(a, b), wall);
    if (!fresh)
      fail(subject_,
           fmt::format("walls[{}] and walls[{}] lie on one another", place->second, wall));
    const std::size_t i = result_.halves.size();
    result_.halves.push_back({a, b, wall, 0, i + 1});
    result_.halves.push_back({b, a, wall, 0, i});
  }

  double angleOf(std::size_t half) const {
    const glm::dvec2 d = result_.end(half) - result_.start(half);
    return std::atan2(d.y, d.x);
  }

  /// The next half along a face is, at each junction, the one clockwise of where we came from.
  void linkHalves() {
    std::vector<std::vector<std::size_t>> leaving(result_.junctions.size());
    for (std::size_t h = 0; h < result_.halves.size(); ++h)
      leaving[result_.halves[h].from].push_back(h);
    next_.resize(result_.halves.size());
    for (auto& fan : leaving) {
      if (fan.size() == 1) {
        const glm::dvec2 p = result_.start(fan[0]);
        fail(subject_, fmt::format("walls[{}] ends in the open at [{:.3f}, {:.3f}]",
                                   result_.halves[fan[0]].wall, p.x, p.y));
      }
      std::sort(fan.begin(), fan.end(),
                [&](std::size_t a, std::size_t b) { return angleOf(a) < angleOf(b); });
      for (std::size_t k = 0; k < fan.size(); ++k)
        next_[result_.halves[fan[k]].twin] = fan[(k + fan.size() - 1) % fan.size()];
    }
  }

  void traceFaces() {
    constexpr auto kUnset = static_cast<std::size_t>(-1);
    for (HalfWall& half : result_.halves) half.face = kUnset;
    std::size_t outer = 0;
    for (std::size_t first = 0; first < result_.halves.size(); ++first) {
      if (result_.halves[first].face != kUnset) continue;
      std::vector<std::size_t> face;
      for (std::size_t h = first; result_.halves[h].face == kUnset; h = next_[h]) {
        result_.halves[h].face = result_.faces.size();
        face.push_back(h);
      }
      result_.faces.push_back(face);
      outer += signedArea(result_.polygon(result_.faces.size() - 1)) < 0;
    }
    if (outer != 1)
      fail(subject_, fmt::format("the walls fall apart into {} groups that do not meet", outer));
  }

  const std::vector<PlanWall>& walls_;
  const std::string& subject_;
  PlanarFaces result_;
  std::vector<std::size_t> next_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> pairs_;
};

}  // namespace

std::vector<glm::dvec2> PlanarFaces::polygon(std::size_t face) const {
  std::vector<glm::dvec2> points;
  for (const std::size_t half : faces[face]) points.push_back(start(half));
  return points;
}

PlanarFaces tracePlanarFaces(const std::vector<PlanWall>& walls, const std::string& subject) {
  return Tracer(walls, subject).run();
}

}  // namespace enfilade
