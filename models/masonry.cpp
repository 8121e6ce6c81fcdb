// Pedestals and slabs of stone.
#include <algorithm>
#include <cmath>

#include "models/moulded_block.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

Shape makePlinth(const ShapeNumbers& n) {
  const double h = n.at("height"), half = 0.5 * n.at("width"), m = std::min(0.06, 0.2 * h);
  const std::vector<MouldingPoint> profile{
      {0.6 * m, 0, 0.55},     {0.6 * m, 1.3 * m, 0.8},      {0.2 * m, 1.7 * m, 0.7},
      {0, 2 * m, 0.75},       {0, 0.5 * h, 0.95},           {0, h - 1.5 * m, 0.9},
      {0.35 * m, h - m, 0.8}, {0.7 * m, h - 0.7 * m, 0.95}, {0.7 * m, h, 1}};
  return {{}, [=](MeshBuilder& mesh) { raiseMouldedBlock({half, half}, profile, 1, mesh); }};
}

Shape makeSlab(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), z = 0.5 * n.at("depth"), h = n.at("height");
  return {{}, [=](MeshBuilder& mesh) { mesh.box({-x, 0, -z}, {x, h, z}, "XxYZz", 1); }};
}

}  // namespace

std::vector<ShapeKind> masonryKinds() {
  return {
      {"plinth", 0, {{"height", 1, 0.05, 5}, {"width", 0.5, 0.05, 10}}, makePlinth},
      {"slab",
       0,
       {{"width", 1, 0.02, 100}, {"depth", 1, 0.02, 100}, {"height", 0.1, 0.01, 10}},
       makeSlab},
  };
}

}  // namespace enfilade
