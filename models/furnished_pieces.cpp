#include "models/furnished_pieces.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "models/split_piece.h"
#include "scene/error.h"

namespace enfilade {
namespace {

/// Moves the meshes of `model`, and what they wear, into `building`; returns their indices there.
std::vector<std::uint32_t> moveMeshes(Building& model, Building& building) {
  const auto first_array = static_cast<std::uint32_t>(building.vertex_arrays.size());
  for (VertexArrays& vertices : model.vertex_arrays) {
    building.vertex_arrays.push_back(std::move(vertices));
  }
  std::map<std::uint32_t, std::uint32_t> images, materials;
  std::vector<std::uint32_t> moved;
  for (Mesh& mesh : model.meshes) {
    const auto [worn, is_new] =
        materials.try_emplace(mesh.material, static_cast<std::uint32_t>(building.materials.size()));
    if (is_new) {
      Material material = model.materials[mesh.material];
      material.name = model.name + "/" + material.name;
      if (material.image != kNone) {
        const auto [shown, first] =
            images.try_emplace(material.image, static_cast<std::uint32_t>(building.images.size()));
        if (first) building.images.push_back(std::move(model.images[material.image]));
        material.image = shown->second;
      }
      building.materials.push_back(std::move(material));
    }
    mesh.material = worn->second;
    mesh.vertices += first_array;
    moved.push_back(static_cast<std::uint32_t>(building.meshes.size()));
    building.meshes.push_back(std::move(mesh));
  }
  return moved;
}

}  // namespace

const FurnishedPiece& FurnishedPieces::piece(const std::string& name) {
  const auto known = pieces_.find(name);
  if (known != pieces_.end()) return known->second;
  return pieces_.emplace(name, load(plan_.pieces.at(name))).first->second;
}

FurnishedPiece FurnishedPieces::load(const PlanPiece& wanted) {
  const FurnitureEntry* entry = library_ == nullptr ? nullptr : library_->find(wanted.furniture);
  if (entry == nullptr) {
    throw Error(
        ErrorKind::kBadInput, subject_,
        fmt::format("pieces.{}.furniture: no catalogue has \"{}\"", wanted.name, wanted.furniture));
  }
  Building model = library_->load(*entry);
  glm::dvec3 scale(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (wanted.size[axis] > 0) scale[axis] = wanted.size[axis] / entry->size[axis];
  }
  FurnishedPiece piece;
  piece.place = glm::scale(glm::dmat4(1), scale) * glm::dmat4(model.nodes[0].world_from_node);
  piece.top = entry->top * scale.y;
  piece.meshes = moveMeshes(model, building_);
  if (to_be_lit_) splitPiece(building_, piece.meshes, glm::mat4(piece.place));
  for (const std::uint32_t mesh : piece.meshes) {
    piece.triangles += building_.meshes[mesh].indices.size() / 3;
  }
  credits_.insert(fmt::format("{} by {} ({})", entry->name, entry->creator, entry->licence));
  return piece;
}

}  // namespace enfilade
