// Counts the pixels in which portal culling differs from the whole building, over random views from
// free space: any at all is geometry that a cell should have had.
//   score_views HOUSE [VIEWS] [-v]
// Eyes have no solid voxel around them, so that the near plane cuts no wall; one in ten that fall
// outdoors is kept.  -v names every view that differs.
#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <string>

#include "app/frame_painter.h"
#include "portals/house.h"
#include "preprocess/random_sphere.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene/camera.h"
#include "scene/error.h"
#include "visibility/object_index.h"
#include "visibility/portal_culling.h"

namespace enfilade {
namespace {

constexpr int kWidth = 320, kHeight = 256;

bool isFreeAround(const CellGrid& grid, const glm::ivec3& v) {
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 beside = v + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    if (grid.labelAt(beside) == CellGrid::kSolidVoxel) return false;
  }
  return true;
}

glm::vec3 randomEye(const House& house, std::mt19937& random) {
  const CellGrid& grid = house.grid;
  const glm::vec3 half = 0.5f * grid.voxel() * glm::vec3(grid.size());
  while (true) {
    const glm::vec3 p = grid.origin() + half * (1.0f + randomInCube(random));
    const CellGrid::Label label = grid.labelAt(grid.voxelOf(p));
    const bool outdoors = label == kExterior;
    if (label >= house.graph.cells.size() || (outdoors && randomUnit(random) > 0.1f)) continue;
    if (isFreeAround(grid, grid.voxelOf(p))) return p;
  }
}

class Comparison {
 public:
  explicit Comparison(const House& house)
      : house_(house),
        context_(createOsMesaContext(2)),
        renderer_(*context_, house.building),
        index_(house) {}

  std::size_t differingPixels(const View& view) {
    const CellId eye = locate(house_.graph, house_.grid, view.eye).cell;
    draw(index_.inFrustum(view), view, whole_);
    draw(index_.visible(cullByPortals(house_.graph, view, eye)), view, culled_);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole_.rgba.size(); i += 4) {
      differing += !std::equal(&whole_.rgba[i], &whole_.rgba[i] + 3, &culled_.rgba[i]);
    }
    return differing;
  }

 private:
  void draw(const std::vector<std::uint32_t>& objects, const View& view, Image& out) {
    renderer_.begin(kWidth, kHeight);
    renderer_.draw(objects, view);
    renderer_.finish();
    renderer_.readColor(out);
  }

  const House& house_;
  std::unique_ptr<GlContext> context_;
  Renderer renderer_;
  ObjectIndex index_;
  Image whole_, culled_;
};

void scoreViews(const std::string& folder, int views, bool verbose) {
  const House house = readHouse(folder);
  Comparison comparison(house);
  Camera camera = walkingCamera(house, 1.0f, kWidth, kHeight);
  std::mt19937 random(7);
  std::size_t pixels = 0, worst = 0;
  int differing = 0;
  for (int i = 0; i < views; ++i) {
    camera.pose.position = randomEye(house, random);
    const float heading = glm::two_pi<float>() * randomUnit(random);
    const float pitch = 1.5f * (randomUnit(random) - 0.5f);
    camera.pose.world_from_camera_rotation =
        glm::angleAxis(heading, glm::vec3(0, 1, 0)) * glm::angleAxis(pitch, glm::vec3(1, 0, 0));
    const std::size_t here = comparison.differingPixels(camera.view());
    pixels += here;
    worst = std::max(worst, here);
    differing += here > 0;
    const glm::vec3& eye = camera.pose.position;
    if (verbose && here > 0) {
      fmt::print("{} pixels from ({:.2f}, {:.2f}, {:.2f})\n", here, eye.x, eye.y, eye.z);
    }
  }
  fmt::print("{}: {} pixels differ in {} of {} views of {}x{}, {} at the worst\n", folder, pixels,
             differing, views, kWidth, kHeight, worst);
}

}  // namespace
}  // namespace enfilade

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: score_views HOUSE [VIEWS] [-v]\n");
    return 1;
  }
  const bool verbose = std::string(argv[argc - 1]) == "-v";
  try {
    const int views = argc > 2 ? std::atoi(argv[2]) : 0;
    enfilade::scoreViews(argv[1], views > 0 ? views : 1000, verbose);
  } catch (const enfilade::Error& error) {
    fmt::print(stderr, "score_views: {}\n", error.what());
    return 2;
  }
}
