// A whole frame of 640 × 512 by each method: the mean over a walk through a house.
// ENFILADE_BENCH_HOUSE names a house with all kinds of images; without it the sample gallery is
// raised and preprocessed first, with small images.  ENFILADE_BENCH_THREADS chooses the threads.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "app/frame_painter.h"
#include "models/samples.h"
#include "preprocess/preprocess.h"
#include "preprocess/tour.h"
#include "scene/gltf_writer.h"
#include "tests/bench/bench_scenes.h"

namespace enfilade {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 512;

std::string houseFolder() {
  if (const char* named = std::getenv("ENFILADE_BENCH_HOUSE")) return named;
  const std::string folder =
      (std::filesystem::temp_directory_path() / "enfilade-bench-gallery").string();
  const std::string model = folder + ".glb";
  writeGlb(model, raiseSample("gallery"));
  PreprocessParameters parameters;
  parameters.image.bake = {};
  parameters.image.image_size = 128;
  preprocessBuilding(model, folder, parameters);
  return folder;
}

/// What all methods share.
struct Walk {
  Walk() {
    TourParameters parameters;
    parameters.frames = 60;
    path = makeTour(house, parameters).path;
    painter =
        std::make_unique<FramePainter>(*context, house, images, kWidth, kHeight, bench::threads());
  }
  // Before anything is baked: the first context of a process decides how many threads draw.
  std::unique_ptr<GlContext> context = createOsMesaContext(bench::threads());
  std::string folder = houseFolder();
  House house = readHouse(folder);
  PortalImages images{house, folder};
  CameraPath path;
  std::unique_ptr<FramePainter> painter;
};

void frames(benchmark::State& state, Method method) {
  static Walk walk;
  Camera camera = walkingCamera(walk.house, walk.path.vertical_fov, kWidth, kHeight);
  walk.painter->prepare(method);
  std::size_t frame = 0;
  for (auto _ : state) {
    camera.pose = walk.path.poses[frame++ % walk.path.poses.size()].pose;
    walk.painter->paint(method, camera);
  }
}

void addAll() {
  for (const MethodInfo& info : allMethods()) {
    benchmark::RegisterBenchmark((std::string("frame/") + info.name).c_str(),
                                 [method = info.method](benchmark::State& s) { frames(s, method); })
        ->Iterations(180)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace enfilade

int main(int argc, char** argv) {
  enfilade::addAll();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
