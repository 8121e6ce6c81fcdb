// Making a layered depth image, step by step, of captures of 256 × 256 pixels in the furnished,
// textured sculpture gallery of the sample building: drawing and reading back a capture (llvmpipe,
// ENFILADE_BENCH_THREADS), resolving it into samples, inserting it into the image, packing the
// image, and all of it for the default plan of captures.  Published for inserting one image of
// 256 × 256: 130 ms (Stoev 2002).

#include <benchmark/benchmark.h>

#include <chrono>

#include "ibr/ldi_builder.h"
#include "ibr/portal_capture.h"
#include "models/samples.h"
#include "tests/bench/bench_scenes.h"

namespace enfilade {
namespace {

constexpr double kFarDepth = 80.0;  // [m]
constexpr std::size_t kInsertedBefore = 12;

/// An upright square of 2 m across the sculpture gallery; the viewer stands at smaller x.
Portal squareInTheGallery() {
  Portal portal;
  portal.polygon = {{8, 0.1f, -8}, {8, 0.1f, -6}, {8, 2.1f, -6}, {8, 2.1f, -8}};
  portal.plane = planeOf(portal.polygon);
  return portal;
}

/// What the benchmarks share, made once.
struct Scene {
  Building building = raiseSample("gallery");
  std::vector<std::uint32_t> objects = bench::allObjects(building);
  std::unique_ptr<GlContext> context = createOsMesaContext(bench::threads());
  Renderer renderer{*context, building};
  Portal portal = squareInTheGallery();
  ImageParameters parameters;
  std::vector<PlanarCamera> cameras;  ///< of the plan's captures, the central one first
  float threshold = 0;

  Scene() {
    parameters.image_size = 269;  // of a portal 2.1 m high: 256 and its margin for this one
    for (const glm::dvec3& at : captureViewpoints(portal, true, 1.6f, parameters)) {
      cameras.push_back(portalCamera(portal, true, at, parameters));
    }
    threshold = disparityThreshold(cameras[0], parameters.depth_threshold);
  }

  DepthImage capture(const PlanarCamera& camera) {
    return captureThroughPortal(
        renderer, camera, [&](const View&) { return objects; }, kFarDepth);
  }
  CaptureSamples samples(std::size_t i, int rays) {
    return resolveCapture(capture(refined(cameras[i], rays)), rays, threshold);
  }
  LdiBuilder builder() const {
    return {cameras[0], {parameters.depth_threshold, parameters.ldi_half_width}};
  }
};

Scene& scene() {
  static Scene shared;
  return shared;
}

void drawCapture(benchmark::State& state) {
  const int rays = static_cast<int>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(scene().capture(refined(scene().cameras[3], rays)));
  }
}

void resolve(benchmark::State& state) {
  const int rays = static_cast<int>(state.range(0));
  const DepthImage image = scene().capture(refined(scene().cameras[3], rays));
  std::size_t samples = 0;
  for (auto _ : state) samples = resolveCapture(image, rays, scene().threshold).samples.size();
  state.counters["samples"] = static_cast<double>(samples);
}

void insert(benchmark::State& state) {
  const int rays = static_cast<int>(state.range(0));
  LdiBuilder before = scene().builder();
  for (std::size_t i = 0; i < kInsertedBefore; ++i) before.insert(scene().samples(i, rays));
  const CaptureSamples next = scene().samples(kInsertedBefore, rays);
  for (auto _ : state) {
    LdiBuilder builder = before;
    const auto start = std::chrono::steady_clock::now();
    builder.insert(next);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    state.SetIterationTime(taken.count());
  }
  state.counters["samples"] = static_cast<double>(next.samples.size());
}

std::vector<CaptureSamples> allSamples(int rays) {
  std::vector<CaptureSamples> captures;
  for (std::size_t i = 0; i < scene().cameras.size(); ++i) {
    captures.push_back(scene().samples(i, rays));
  }
  return captures;
}

void finish(benchmark::State& state) {
  LdiBuilder builder = scene().builder();
  for (const CaptureSamples& capture : allSamples(2)) builder.insert(capture);
  std::size_t samples = 0;
  for (auto _ : state) samples = builder.finish().samples.size();
  state.counters["samples"] = static_cast<double>(samples);
}

/// Inserting all captures of the plan, and packing.
void insertAll(benchmark::State& state) {
  const std::vector<CaptureSamples> captures = allSamples(2);
  for (auto _ : state) {
    LdiBuilder builder = scene().builder();
    for (const CaptureSamples& capture : captures) builder.insert(capture);
    benchmark::DoNotOptimize(builder.finish());
  }
  state.counters["captures"] = static_cast<double>(captures.size());
}

/// From the geometry to the image, drawing included.
void bake(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(bakeLdi(
        scene().renderer, scene().portal, true, 1.6f, scene().parameters,
        [&](const View&) { return scene().objects; }, kFarDepth));
  }
  state.counters["captures"] = static_cast<double>(scene().cameras.size());
}

BENCHMARK(drawCapture)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(resolve)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(insert)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(finish)->Unit(benchmark::kMillisecond);
BENCHMARK(insertAll)->Unit(benchmark::kMillisecond);
BENCHMARK(bake)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace enfilade

BENCHMARK_MAIN();
