// Frames of 640 × 512 by OSMesa, read back or not.  ENFILADE_BENCH_THREADS chooses the threads.
// sift:0 hands every triangle to OpenGL, sift:1 those that the sieve leaves.

#include <benchmark/benchmark.h>

#include "render/renderer.h"
#include "render/triangle_sieve.h"
#include "scene/gltf_reader.h"
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
  renderer.setSifting(state.range(0) != 0);
  const std::vector<std::uint32_t> objects = bench::allObjects(building);
  DrawCounts counts;
  for (auto _ : state) {
    renderer.begin(kWidth, kHeight);
    counts = renderer.draw(objects, camera.view());
    renderer.finish();
  }
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangleCount(building)),
                                                     benchmark::Counter::kIsIterationInvariantRate);
  state.counters["drawn"] = static_cast<double>(counts.triangles);
  state.counters["calls"] = static_cast<double>(counts.draw_calls);
}

void spheres(benchmark::State& state, int objects, int per_object, int materials, bool textured,
             bool double_sided) {
  drawFrames(state, bench::spheres(objects, per_object, materials, textured, double_sided),
             cameraAt({1, 2, 9}, {0, 0, 0}));
}

/// The sieve by itself.
void sieve(benchmark::State& state, int objects, int per_object) {
  const Building building = bench::spheres(objects, per_object, 1, false, false);
  TriangleSieve sieve(worldGeometry(building));
  std::vector<SieveObject> all;
  for (const std::uint32_t o : bench::allObjects(building)) all.push_back({o, false, true});
  SieveView view;
  view.clip_from_world = cameraAt({1, 2, 9}, {0, 0, 0}).clipFromWorld();
  view.width = kWidth;
  view.height = kHeight;
  for (auto _ : state) sieve.sift(all, view);
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangleCount(building)),
                                                     benchmark::Counter::kIsIterationInvariantRate);
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

/// A portal that fills the frame with a warped image.
void screenPolygon(benchmark::State& state) {
  const Building building;
  Renderer renderer(context(), building);
  Image picture;
  picture.width = kWidth;
  picture.height = kHeight;
  picture.rgba.assign(4 * kWidth * kHeight, 200);
  const std::vector<ScreenPolygon> polygons = {
      {{{-50, -50, -5}, {50, -50, -5}, {50, 50, -5}, {-50, 50, -5}}}};
  for (auto _ : state) {
    renderer.begin(kWidth, kHeight);
    renderer.drawScreenPolygons(polygons, picture, {0, 0, kWidth, kHeight},
                                Camera{}.clipFromWorld());
    renderer.finish();
  }
}

void model(benchmark::State& state, const char* name, const glm::vec3& eye, float yaw) {
  const std::string file = bench::modelFile(name);
  if (file.empty()) return state.SkipWithError("no such model");
  Camera camera;
  camera.pose = poseFromAngles(eye, yaw, 0);
  drawFrames(state, readGltf(file), camera);
}

BENCHMARK(screenPolygon)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

#define ENFILADE_BENCH(...)           \
  BENCHMARK_CAPTURE(__VA_ARGS__)      \
      ->Unit(benchmark::kMillisecond) \
      ->MeasureProcessCPUTime()       \
      ->UseRealTime()

#define ENFILADE_BENCH_DRAW(...) ENFILADE_BENCH(__VA_ARGS__)->ArgName("sift")->Arg(0)->Arg(1)

ENFILADE_BENCH_DRAW(fill, plain, false);
ENFILADE_BENCH_DRAW(fill, textured, true);
ENFILADE_BENCH(sieve, 200k, 8, 25000);
ENFILADE_BENCH(sieve, 1000_objects, 1000, 100);
ENFILADE_BENCH(readBack, color, false);
ENFILADE_BENCH(readBack, depth, true);
ENFILADE_BENCH_DRAW(spheres, 200k_one_sided, 8, 25000, 1, false, false);
ENFILADE_BENCH_DRAW(spheres, 200k_double_sided, 8, 25000, 1, false, true);
ENFILADE_BENCH_DRAW(spheres, 200k_textured, 8, 25000, 1, true, false);
ENFILADE_BENCH_DRAW(spheres, 1000_objects_20_materials, 1000, 100, 20, true, true);
ENFILADE_BENCH_DRAW(spheres, 1000_objects_1_material, 1000, 100, 1, true, true);

ENFILADE_BENCH_DRAW(model, duplex, "duplex.glb", {2, 1.5f, 5}, 0.5f);
ENFILADE_BENCH_DRAW(model, freedoom, "freedoom-e1m1.glb", {0, 2, 0}, 0.3f);
ENFILADE_BENCH_DRAW(model, dream_apartment, "dream-apartment.glb", {5, 1.6f, -5}, 0.5f);

}  // namespace
}  // namespace enfilade

BENCHMARK_MAIN();
