#include "models/shapes.h"

namespace enfilade {
namespace {

const std::vector<ShapeKind>& allKinds() {
  static const std::vector<ShapeKind> kinds = [] {
    std::vector<ShapeKind> all;
    for (const auto& some : {sculptureKinds(), bustKinds(), turneryKinds(), masonryKinds(),
                             furnitureKinds(), hangingKinds(), plantKinds(), stairwayKinds()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return kinds;
}

double shareSum(const Shape& shape) {
  double sum = 0;
  for (const CurvedSurface& surface : shape.surfaces) sum += surface.share;
  return sum;
}

}  // namespace

const ShapeParameter* ShapeKind::find(const std::string& parameter) const {
  for (const ShapeParameter& p : parameters)
    if (p.name == parameter) return &p;
  return nullptr;
}

const ShapeKind* findShape(const std::string& name) {
  for (const ShapeKind& kind : allKinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

std::vector<std::string> shapeNames() {
  std::vector<std::string> names;
  for (const ShapeKind& kind : allKinds()) names.emplace_back(kind.name);
  return names;
}

std::size_t countTriangles(const Shape& shape, double triangles) {
  std::size_t count = 0;
  const double each = triangles / shareSum(shape);
  for (const CurvedSurface& surface : shape.surfaces)
    count += triangleCount(surface, gridFor(surface, each * surface.share));
  if (shape.flat) {
    MeshBuilder flat;
    shape.flat(flat);
    count += flat.triangleCount();
  }
  return count;
}

void raiseShape(const Shape& shape, double triangles, MeshBuilder& mesh) {
  const double each = triangles / shareSum(shape);
  for (const CurvedSurface& surface : shape.surfaces)
    raiseSurface(surface, gridFor(surface, each * surface.share), mesh);
  if (shape.flat) shape.flat(mesh);
}

}  // namespace enfilade
