// Pictures of 640 × 512 by Embree, and visibility rays.  ENFILADE_BENCH_THREADS chooses the
// threads.

#include <benchmark/benchmark.h>

#include <random>

#include "render/ray_caster.h"
#include "scene/gltf_reader.h"
#include "tests/bench/bench_scenes.h"

namespace enfilade {
namespace {

void renderFrames(benchmark::State& state, const Building& building, const Camera& camera) {
  const RayCaster caster(building, {}, bench::threads());
  Image image;
  for (auto _ : state) caster.render(camera, 640, 512, image);
}

void spheres(benchmark::State& state, int objects, int per_object, bool textured,
             bool double_sided) {
  Camera camera;
  camera.pose = lookAt({1, 2, 9}, {0, 0, 0});
  renderFrames(state, bench::spheres(objects, per_object, 1, textured, double_sided), camera);
}

void model(benchmark::State& state, const char* name, const glm::vec3& eye, float yaw) {
  const std::string file = bench::modelFile(name);
  if (file.empty()) return state.SkipWithError("no such model");
  Camera camera;
  camera.pose = poseFromAngles(eye, yaw, 0);
  renderFrames(state, readGltf(file), camera);
}

/// A million rays from points in the building's box in all directions.
void visibilityRays(benchmark::State& state, const char* name) {
  const std::string file = bench::modelFile(name);
  if (file.empty()) return state.SkipWithError("no such model");
  const Building building = readGltf(file);
  const Box box = worldBounds(building);
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<Ray> rays(1 << 20);
  for (Ray& ray : rays) {
    const glm::vec3 part(random() & 0xffff, random() & 0xffff, random() & 0xffff);
    ray = {box.min + part / 65535.0f * box.size(),
           glm::normalize(glm::vec3(normal(random), normal(random), normal(random))), 0.01f, 100};
  }
  const RayCaster caster(building, {}, bench::threads());
  std::vector<RayHit> hits(rays.size());
  for (auto _ : state) caster.cast(rays, true, hits);
  state.counters["rays/s"] = benchmark::Counter(static_cast<double>(rays.size()),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

void build(benchmark::State& state, int objects, int per_object) {
  const Building building = bench::spheres(objects, per_object, 1, false, true);
  for (auto _ : state) benchmark::DoNotOptimize(RayCaster(building, {}, bench::threads()));
}

#define ENFILADE_BENCH(...)           \
  BENCHMARK_CAPTURE(__VA_ARGS__)      \
      ->Unit(benchmark::kMillisecond) \
      ->MeasureProcessCPUTime()       \
      ->UseRealTime()

ENFILADE_BENCH(spheres, 200k_one_sided, 8, 25000, false, false);
ENFILADE_BENCH(spheres, 200k_double_sided, 8, 25000, false, true);
ENFILADE_BENCH(spheres, 200k_textured, 8, 25000, true, true);
ENFILADE_BENCH(spheres, 3200k, 8, 400000, false, true);
ENFILADE_BENCH(model, duplex, "duplex.glb", {2, 1.5f, 5}, 0.5f);
ENFILADE_BENCH(model, freedoom, "freedoom-e1m1.glb", {0, 2, 0}, 0.3f);
ENFILADE_BENCH(model, dream_apartment, "dream-apartment.glb", {5, 1.6f, -5}, 0.5f);
ENFILADE_BENCH(visibilityRays, duplex, "duplex.glb");
ENFILADE_BENCH(visibilityRays, dream_apartment, "dream-apartment.glb");
ENFILADE_BENCH(build, 3200k, 8, 400000);

}  // namespace
}  // namespace enfilade

BENCHMARK_MAIN();
