#include "cell_plan.h"

#include <algorithm>
#include <array>

#include "scene/image.h"

namespace enfilade {
namespace {

constexpr int kScale = 5;  // pixels a voxel

using Colour = std::array<int, 3>;

class Canvas {
 public:
  Canvas(const VoxelGrid& grid, Image& image) : grid_(grid), image_(image) {
    image_.width = grid.size.x * kScale;
    image_.height = grid.size.z * kScale;
    image_.rgba.assign(std::size_t(image_.width) * std::size_t(image_.height) * 4, 255);
  }
  void set(int x, int y, const Colour& colour) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    auto* p = &image_.rgba[(std::size_t(y) * std::size_t(image_.width) + std::size_t(x)) * 4];
    for (std::size_t i = 0; i < 3; ++i) p[i] = static_cast<std::uint8_t>(colour[i]);
  }
  void line(const glm::vec3& a, const glm::vec3& b, const Colour& colour) {
    constexpr int kSteps = 400;
    for (int i = 0; i <= kSteps; ++i) {
      const glm::vec3 at = glm::mix(a, b, float(i) / kSteps);
      const glm::vec3 p = (at - grid_.origin) / grid_.voxel * float(kScale);
      for (int d = 0; d < 2; ++d) {
        set(int(p.x) + d, int(p.z), colour);
        set(int(p.x), int(p.z) + d, colour);
      }
    }
  }

 private:
  const VoxelGrid& grid_;
  Image& image_;
};

Colour colourOf(const VoxelGrid& grid, const CutCells& cut, const glm::ivec3& v) {
  const int label = labelAt(grid, cut, v);
  if (label == CellGrid::kSolidVoxel) {
    const bool solid = grid.bits[grid.index(v.x, v.y, v.z)] & kVoxelSolid;
    return solid ? Colour{40, 40, 40} : Colour{120, 0, 120};
  }
  if (label == CellGrid::kCutVoxel) return {255, 120, 120};
  if (label == 0) return {225, 235, 225};
  return {90 + label * 73 % 150, 90 + label * 151 % 150, 90 + label * 211 % 150};
}

void drawPortals(Canvas& canvas, const CutCells& cut, float y) {
  constexpr std::array<Colour, 3> kColours{Colour{0, 160, 0}, {255, 0, 0}, {0, 0, 255}};
  for (const Portal& portal : cut.graph.portals) {
    Box box;
    for (const glm::vec3& p : portal.polygon) box.extend(p);
    if (box.min.y > y + 1.5f || box.max.y < y - 1.3f) continue;
    for (std::size_t i = 0; i < portal.polygon.size(); ++i) {
      canvas.line(portal.polygon[i], portal.polygon[(i + 1) % portal.polygon.size()],
                  kColours[static_cast<std::size_t>(portal.kind)]);
    }
  }
}

}  // namespace

void drawPlan(const std::string& file, const VoxelGrid& grid, const CutCells& cut, float y,
              const Truth& truth) {
  Image image;
  Canvas canvas(grid, image);
  const int voxel_y = grid.voxelOf({0, y, 0}).y;
  for (int x = 0; x < image.width; ++x) {
    for (int z = 0; z < image.height; ++z) {
      canvas.set(x, z, colourOf(grid, cut, {x / kScale, voxel_y, z / kScale}));
    }
  }
  drawPortals(canvas, cut, y);
  for (const TrueOpening& opening : truth.openings) {
    if (std::abs(opening.center.y - y) > 1.5f) continue;
    for (const glm::vec3 arm : {glm::vec3(0.1f, 0, 0.1f), glm::vec3(0.1f, 0, -0.1f)}) {
      canvas.line(opening.center - arm, opening.center + arm, {0, 0, 0});
    }
  }
  writePng(file, image);
}

}  // namespace enfilade
