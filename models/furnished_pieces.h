#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "models/floor_plan.h"
#include "models/furniture_library.h"
#include "scene/building.h"

namespace enfilade {

/// A piece of a catalogue, in the building that it furnishes.
struct FurnishedPiece {
  std::vector<std::uint32_t> meshes;  ///< in Building::meshes
  glm::dmat4 place{1};                ///< of all of them: brings the piece to its size
  std::uint64_t triangles = 0;
  double top = 0;  ///< [m] above its foot: where things stand on it
};

/// Brings pieces of the furniture catalogues into a building, each once, and knows whom to thank.
class FurnishedPieces {
 public:
  /// `library` may be null if the plan has no such piece.  All must outlive it.  `to_be_lit`: large
  /// faces are split.
  FurnishedPieces(const FloorPlan& plan, const FurnitureLibrary* library, Building& building,
                  const std::string& subject, bool to_be_lit)
      : plan_(plan),
        library_(library),
        building_(building),
        subject_(subject),
        to_be_lit_(to_be_lit) {}

  /// Loads it when first asked for.  Throws Error (kBadInput) for an id that no catalogue has.
  const FurnishedPiece& piece(const std::string& name);

  /// "Bed by Scopia (licence)", a line each, in order.
  const std::set<std::string>& credits() const noexcept { return credits_; }

 private:
  FurnishedPiece load(const PlanPiece& piece);

  const FloorPlan& plan_;
  const FurnitureLibrary* library_;
  Building& building_;
  const std::string& subject_;
  bool to_be_lit_;
  std::map<std::string, FurnishedPiece> pieces_;
  std::set<std::string> credits_;
};

}  // namespace enfilade
