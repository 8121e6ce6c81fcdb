// McMillan, A List-Priority Rendering Algorithm for Redisplaying Projected Surfaces, 1995.
#include "ibr/sheets.h"

#include <cmath>

namespace enfilade {
namespace {

int tileColumns(const PlanarCamera& camera) { return (camera.width + kLdiTile - 1) / kLdiTile; }
int tileRows(const PlanarCamera& camera) { return (camera.height + kLdiTile - 1) / kLdiTile; }

/// The tile of pixel coordinate a / w, kept within −1 … tiles; w may be 0.
int tileOf(double a, double w, int tiles) {
  const double tile = a / w / kLdiTile;
  if (!(tile >= 0.0)) {
    return -1;
  }
  return tile < tiles ? static_cast<int>(tile) : tiles;
}

}  // namespace

SheetOrder sheetOrder(const PlanarCamera& reference, const glm::dvec3& eye) {
  const glm::dvec3 q = glm::inverse(reference.world_from_pixel) * (eye - reference.center);
  // An eye beside the reference's is seen infinitely far to one side: toward that side.
  const double w = q.z == 0.0 ? 1e-300 : q.z;
  SheetOrder order;
  order.toward = w > 0.0;
  order.column = tileOf(q.x, w, tileColumns(reference));
  order.row = tileOf(q.y, w, tileRows(reference));
  return order;
}

int sheetCount(const SheetOrder& order, const PlanarCamera& reference) {
  const bool in_columns = order.column >= 0 && order.column < tileColumns(reference);
  const bool in_rows = order.row >= 0 && order.row < tileRows(reference);
  return (in_columns ? 2 : 1) * (in_rows ? 2 : 1);
}

}  // namespace enfilade
