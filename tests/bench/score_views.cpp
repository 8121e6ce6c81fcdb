// Counts the pixels in which portal culling differs from the whole building, over random views from
// places of every kind: any at all is geometry that a cell should have had.
//   score_views HOUSE [VIEWS] [-v]
// -v names every view that differs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "app/frame_painter.h"
#include "portals/house.h"
#include "render/gl_context.h"
#include "scene/error.h"
#include "tests/app/random_views.h"

namespace enfilade {
namespace {

using testing::EyePlace;
using testing::kEyePlaces;
using testing::RandomView;
using testing::RandomViews;

constexpr int kWidth = 320, kHeight = 256;

struct Tally {
  std::size_t views = 0, whole = 0, differing = 0, pixels = 0, worst = 0;

  void add(std::size_t pixels_here) {
    pixels += pixels_here;
    worst = std::max(worst, pixels_here);
    differing += pixels_here > 0;
  }
};

class Comparison {
 public:
  explicit Comparison(House& house)
      : house_(house),
        context_(createOsMesaContext(2)),
        painter_(*context_, house, no_images_, kWidth, kHeight, 2) {}

  void compare(const RandomView& view, bool verbose, Tally& tally) {
    painter_.paint(Method::kGeometry, view.camera);
    painter_.read(whole_);
    painter_.paint(Method::kCulling, view.camera);
    painter_.read(culled_);
    ++tally.views;
    tally.whole += painter_.visibleSet().cells.size() == house_.graph.cells.size();
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole_.rgba.size(); i += 4) {
      differing += !std::equal(&whole_.rgba[i], &whole_.rgba[i] + 3, &culled_.rgba[i]);
    }
    tally.add(differing);
    if (verbose && differing > 0) tell(view, differing);
  }

 private:
  void tell(const RandomView& view, std::size_t differing) const {
    const CellId cell = painter_.visibleSet().eye_cell;
    const glm::vec3& eye = view.camera.pose.position;
    const glm::quat& turn = view.camera.pose.world_from_camera_rotation;
    fmt::print("{} pixels from {} in {} ({} {} {}), turned ({} {} {} {}), {:.1f} degrees\n",
               differing, nameOf(view.place), house_.graph.cells[cell].name, eye.x, eye.y, eye.z,
               turn.x, turn.y, turn.z, turn.w, glm::degrees(view.camera.vertical_fov));
  }

  const House& house_;
  PortalImages no_images_;
  std::unique_ptr<GlContext> context_;
  FramePainter painter_;
  Image whole_, culled_;
};

void scoreViews(const std::string& folder, int views, bool verbose) {
  House house = readHouse(folder);
  Comparison comparison(house);
  RandomViews random(house, 7);
  std::array<Tally, kEyePlaces> tallies;
  for (int i = 0; i < views; ++i) {
    const auto place = static_cast<EyePlace>(i % kEyePlaces);
    const RandomView view = random.next(place, static_cast<float>(kWidth) / kHeight);
    comparison.compare(view, verbose, tallies[static_cast<std::size_t>(place)]);
  }
  fmt::print("{}, views of {}x{}\n{:<18} {:>7} {:>12} {:>10} {:>8} {:>8}\n", folder, kWidth,
             kHeight, "eye in or on", "views", "all cells", "differing", "pixels", "worst");
  for (int place = 0; place < kEyePlaces; ++place) {
    const Tally& t = tallies[static_cast<std::size_t>(place)];
    fmt::print("{:<18} {:>7} {:>12} {:>10} {:>8} {:>8}\n", nameOf(static_cast<EyePlace>(place)),
               t.views, t.whole, t.differing, t.pixels, t.worst);
  }
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
