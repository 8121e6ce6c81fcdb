// Frames of 640 × 512 by OSMesa, read back or not.  ENFILADE_BENCH_THREADS chooses the threads.

#include <benchmark/benchmark.h>

#include "render/renderer.h"
#include "tests/bench/bench_scenes.h"

namespace enfilade {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 512;

GlContext& context() {
  static const std::unique_ptr<GlContext> shared = createOsMesaContext(bench::threads());
  return *shared;
}

Camera cameraAt(const glm::vec3& eye, const glm::vec3& target) {
  Camera camera;
  camera.pose = lookAt(eye, target);
  return camera;
}

void drawFrames(benchmark::State& state, const Building& building, const Camera& camera) {
  Renderer renderer(context(), building);
  const std::vector<std::uint32_t> objects = bench::allObjects(building);
  DrawCounts counts;
  for (auto _ : state) {
    renderer.begin(kWidth, kHeight);
    counts = renderer.draw(objects, camera.view());
    renderer.finish();
  }
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(counts.triangles),
                                                     benchmark::Counter::kIsIterationInvariantRate);
  state.counters["calls"] = static_cast<double>(counts.draw_calls);
}

void spheres(benchmark::State& state, int objects, int per_object, int materials, bool textured,
             bool double_sided) {
  drawFrames(state, bench::spheres(objects, per_object, materials, textured, double_sided),
             cameraAt({1, 2, 9}, {0, 0, 0}));
}

void fill(benchmark::State& state, bool textured) {
  Building building = bench::spheres(1, 16, 1, textured, false);
  building.vertex_arrays[0].positions = {
      {-50, -50, -5}, {50, -50, -5}, {50, 50, -5}, {-50, 50, -5}};
  building.vertex_arrays[0].normals.assign(4, {0, 0, 1});
  building.vertex_arrays[0].texcoords = {{0, 20}, {20, 20}, {20, 0}, {0, 0}};
  building.meshes[0].indices = {0, 1, 2, 0, 2, 3};
  building.nodes[0].world_from_node = glm::mat4(1);
  drawFrames(state, building, Camera{});
}

void readBack(benchmark::State& state, bool depth) {
  const Building building = bench::spheres(1, 1000, 1, false, false);
  Renderer renderer(context(), building);
  renderer.begin(kWidth, kHeight);
  renderer.draw(bench::allObjects(building), Camera{}.view());
  renderer.finish();
  Image image;
  std::vector<float> depths;
  for (auto _ : state) {
    if (depth) {
      renderer.readDepth(depths);
    } else {
      renderer.readColor(image);
    }
  }
}

BENCHMARK_CAPTURE(fill, plain, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(fill, textured, true)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(readBack, color, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(readBack, depth, true)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(spheres, 200k_one_sided, 8, 25000, 1, false, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(spheres, 200k_double_sided, 8, 25000, 1, false, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(spheres, 200k_textured, 8, 25000, 1, true, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(spheres, 1000_objects_20_materials, 1000, 100, 20, true, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(spheres, 1000_objects_1_material, 1000, 100, 1, true, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace enfilade

BENCHMARK_MAIN();
