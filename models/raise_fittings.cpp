#include "models/raise_fittings.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "models/furnished_pieces.h"
#include "models/shapes.h"
#include "models/split_piece.h"
#include "scene/error.h"

namespace enfilade {
namespace {

/// A part of a piece, ready to be raised.
struct ReadyPart {
  const PlanPart* plan;
  Shape shape;
  double triangles;             ///< of its curved surfaces at scale 1
  std::uint64_t for_light = 0;  ///< triangles added by splitting flat faces for baked light
  std::uint32_t mesh = kNone;
};

/// Curved surfaces are fine enough for light as they are.
bool isSplitForLight(const Shape& shape) { return shape.surfaces.empty(); }

/// How many triangles splitting a shape for baked light adds.
std::uint64_t addedForLight(const Shape& shape) {
  if (!isSplitForLight(shape)) return 0;
  Building scratch;
  MeshBuilder mesh;
  raiseShape(shape, 0, mesh);
  const std::size_t before = mesh.triangleCount();
  const std::uint32_t index = mesh.addTo(scratch, {}, 0);
  splitPiece(scratch, {&index, 1}, glm::mat4(1));
  return scratch.meshes[index].indices.size() / 3 - before;
}

/// The pieces that the plan uses, and how finely they are to be raised.
class PieceStore {
 public:
  PieceStore(BuildingRaiser& raiser, FurnishedPieces& furnished, std::uint64_t fixed,
             std::uint64_t wanted)
      : raiser_(raiser), furnished_(furnished) {
    for (const PlanStorey& storey : raiser.plan().storeys)
      for (const PlanFitting& f : storey.fittings)
        for (const std::string& name : {f.piece, f.on})
          if (!name.empty()) use(name);
    const std::uint64_t rest = wanted > fixed ? wanted - fixed : 0;
    scale_ = scaleFor(rest);
  }

  /// Null for a piece that is raised here.
  const FurnishedPiece* furnished(const std::string& piece) {
    return raiser_.plan().pieces.at(piece).furniture.empty() ? nullptr : &furnished_.piece(piece);
  }

  /// Where things stand on a piece [m].
  double topOf(const std::string& piece) {
    const FurnishedPiece* furniture = furnished(piece);
    return furniture != nullptr ? furniture->top
                                : raiser_.plan().pieces.at(piece).parts[0].numbers.at("height");
  }

  const std::vector<ReadyPart>& parts(const std::string& piece) const { return pieces_.at(piece); }

  std::uint32_t meshOf(const std::string& piece, std::size_t part) {
    ReadyPart& ready = pieces_.at(piece)[part];
    if (ready.mesh == kNone) {
      MeshBuilder mesh;
      raiseShape(ready.shape, ready.triangles * scale_, mesh);
      const std::string name = part == 0 ? piece : fmt::format("{}.{}", piece, part + 1);
      const std::uint32_t material = raiser_.material(ready.plan->finish);
      ready.mesh = mesh.addTo(raiser_.building(), name, material, !raiser_.toBeLit());
      if (raiser_.toBeLit() && isSplitForLight(ready.shape))
        splitPiece(raiser_.building(), {&ready.mesh, 1}, glm::mat4(1));
    }
    return ready.mesh;
  }

 private:
  void use(const std::string& name) {
    ++places_[name];
    if (const FurnishedPiece* furniture = furnished(name)) {
      furniture_triangles_ += furniture->triangles;
      return;
    }
    const auto [entry, fresh] = pieces_.try_emplace(name);
    if (!fresh) return;
    for (const PlanPart& part : raiser_.plan().pieces.at(name).parts) {
      const ShapeKind& kind = *findShape(part.shape);
      ReadyPart ready{&part, kind.make(part.numbers), kind.triangles * part.detail};
      if (raiser_.toBeLit()) ready.for_light = addedForLight(ready.shape);
      entry->second.push_back(std::move(ready));
    }
  }

  std::uint64_t countAt(double scale) const {
    std::uint64_t count = furniture_triangles_;
    for (const auto& [name, parts] : pieces_)
      for (const ReadyPart& part : parts)
        count += places_.at(name) *
                 (part.for_light + countTriangles(part.shape, part.triangles * scale));
    return count;
  }

  /// Bisects; the counts grow with the scale, but for rounding.
  double scaleFor(std::uint64_t wanted) const {
    double low = 1e-3, high = 1e4, best = 1;
    double best_off = 1e300;
    for (int i = 0; i < 48; ++i) {
      const double middle = std::sqrt(low * high);
      const double off = static_cast<double>(countAt(middle)) - static_cast<double>(wanted);
      if (std::abs(off) < best_off) best = middle;
      best_off = std::min(best_off, std::abs(off));
      (off < 0 ? low : high) = middle;
    }
    return best;
  }

  BuildingRaiser& raiser_;
  FurnishedPieces& furnished_;
  std::uint64_t furniture_triangles_ = 0;  ///< in all places
  std::map<std::string, std::vector<ReadyPart>> pieces_;
  std::map<std::string, std::uint64_t> places_;
  double scale_ = 1;
};

glm::dmat4 turned(const glm::dvec3& at, double degrees, double scale) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), at);
  const glm::dmat4 spun = glm::rotate(moved, glm::radians(degrees), glm::dvec3(0, 1, 0));
  return glm::scale(spun, glm::dvec3(scale));
}

class FittingSetter {
 public:
  FittingSetter(BuildingRaiser& raiser, PieceStore& store, const std::string& subject)
      : raiser_(raiser), store_(store), subject_(subject) {}

  /// `parent`: the room's node, or that of the outside.
  void set(std::size_t storey, std::size_t i, std::uint32_t parent) {
    const PlanFitting& f = raiser_.plan().storeys[storey].fittings[i];
    const double base =
        f.room == kOutsideName ? raiser_.plan().ground : raiser_.plan().storeys[storey].floor;
    const glm::dmat4 place = f.on_wall ? hung(storey, i, base)
                                       : turned({f.at.x, base + f.height, f.at.y}, f.turn, f.scale);
    if (f.on.empty()) {
      addPiece(f.piece, place, parent);
      return;
    }
    const double top = store_.topOf(f.on);
    addPiece(f.on, turned({f.at.x, base + f.height, f.at.y}, f.turn, 1), parent);
    addPiece(f.piece, turned({f.at.x, base + f.height + top, f.at.y}, f.turn, f.scale), parent);
  }

 private:
  /// On the face of the nearest wall, turned into the room.
  glm::dmat4 hung(std::size_t storey, std::size_t i, double base) const {
    const PlanStorey& plan = raiser_.plan().storeys[storey];
    const Layout& layout = raiser_.layout(storey);
    const PlanFitting& f = plan.fittings[i];
    const Outline& outline = layout.outlineOf(plan.roomIndex(f.room));
    const LayoutEdge* nearest = nullptr;
    double least = 1e300;
    for (const LayoutEdge& edge : outline.edges) {
      const double along = glm::dot(f.at - edge.from, edge.direction());
      const double away = std::abs(glm::dot(f.at - edge.from, edge.inward));
      if (along < 0 || along > edge.length() || away >= least) continue;
      least = away;
      nearest = &edge;
    }
    if (nearest == nullptr) fail(storey, i, "is beside no wall");
    const double along = glm::dot(f.at - nearest->from, nearest->direction());
    for (const EdgeOpening& o : nearest->openings) {
      const PlanOpening& opening = plan.openings[layout.openings[o.opening].plan];
      if (along > o.start && along < o.end && f.height > opening.sill && f.height < opening.head)
        fail(storey, i, "would hang in an opening");
    }
    const glm::dvec2 p = nearest->point(along);
    const double turn = glm::degrees(std::atan2(nearest->inward.x, nearest->inward.y));
    return turned({p.x, base + f.height, p.y}, turn + f.turn, f.scale);
  }

  void addPiece(const std::string& piece, const glm::dmat4& place, std::uint32_t parent) {
    const int number = ++count_[piece];
    const std::string name = fmt::format("{}-{}", piece, number);
    if (const auto& light = raiser_.plan().pieces.at(piece).light) {
      addLight(*light, name + "-lamp", place, parent);
    }
    if (const FurnishedPiece* furniture = store_.furnished(piece)) {
      const std::uint32_t node = raiser_.addNode(name, parent, glm::mat4(place * furniture->place));
      for (const std::uint32_t mesh : furniture->meshes) raiser_.addObject(node, mesh);
      return;
    }
    const auto& parts = store_.parts(piece);
    const std::uint32_t node = raiser_.addNode(name, parent, glm::mat4(place));
    if (parts.size() == 1 && parts[0].plan->at == glm::dvec3(0) && parts[0].plan->turn == 0) {
      raiser_.addObject(node, store_.meshOf(piece, 0));
      return;
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const glm::dmat4 m = place * turned(parts[k].plan->at, parts[k].plan->turn, 1);
      raiser_.addObject(raiser_.addNode(fmt::format("{}.{}", name, k + 1), node, glm::mat4(m)),
                        store_.meshOf(piece, k));
    }
  }

  void addLight(const PlanLight& look, const std::string& name, const glm::dmat4& place,
                std::uint32_t parent) {
    Light light;
    light.name = name;
    light.node = raiser_.addNode(
        name, parent,
        glm::mat4(glm::translate(glm::dmat4(1), glm::dvec3(place * glm::dvec4(look.at, 1)))));
    light.color = glm::vec3(glm::pow(look.color, glm::dvec3(2.2)));
    light.intensity = static_cast<float>(look.candela);
    raiser_.building().lights.push_back(light);
  }

  [[noreturn]] void fail(std::size_t storey, std::size_t i, const std::string& reason) const {
    const PlanFitting& f = raiser_.plan().storeys[storey].fittings[i];
    throw Error(
        ErrorKind::kBadInput, subject_,
        fmt::format("storeys[{}].fittings[{}] ({} in {}): {}", storey, i, f.piece, f.room, reason));
  }

  BuildingRaiser& raiser_;
  PieceStore& store_;
  const std::string& subject_;
  std::map<std::string, int> count_;
};

std::uint64_t drawnTriangles(BuildingRaiser& raiser) {
  std::uint64_t count = 0;
  const Building& building = raiser.building();
  for (const Object& object : building.objects)
    if (building.meshOf(object).material != raiser.markerMaterial())
      count += building.meshOf(object).indices.size() / 3;
  return count;
}

}  // namespace

void raiseFittings(BuildingRaiser& raiser,
                   const std::vector<std::vector<std::uint32_t>>& room_nodes,
                   std::uint32_t outside_node, std::uint64_t triangles,
                   const FurnitureLibrary* library, const std::string& subject) {
  FurnishedPieces furnished(raiser.plan(), library, raiser.building(), subject, raiser.toBeLit());
  PieceStore store(raiser, furnished, drawnTriangles(raiser), triangles);
  FittingSetter setter(raiser, store, subject);
  for (std::size_t s = 0; s < raiser.plan().storeys.size(); ++s) {
    const PlanStorey& storey = raiser.plan().storeys[s];
    for (std::size_t i = 0; i < storey.fittings.size(); ++i) {
      const int room = storey.roomIndex(storey.fittings[i].room);
      setter.set(s, i,
                 room == kOutside ? outside_node : room_nodes[s][static_cast<std::size_t>(room)]);
    }
  }
  for (const std::string& credit : furnished.credits()) {
    raiser.building().copyright += "; " + credit;
  }
}

}  // namespace enfilade
