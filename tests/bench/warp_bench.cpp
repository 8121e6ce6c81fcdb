// The warp, in nanoseconds a sample, by splat and number of threads.

#include <benchmark/benchmark.h>

#include <map>

#include "ibr/warp.h"
#include "render/thread_team.h"
#include "tests/bench/warp_scenes.h"

namespace enfilade {
namespace {

const Ldi& ldiOf(int rows) {
  static std::map<int, Ldi> known;
  const auto found = known.find(rows);
  return found != known.end() ? found->second
                              : known.emplace(rows, bench::roomLdi(rows)).first->second;
}

/// All of the picture is the region, and nothing is clipped: every sample is warped.
void everySample(benchmark::State& state, Splat splat) {
  const Ldi& ldi = ldiOf(static_cast<int>(state.range(0)));
  const int threads = static_cast<int>(state.range(1));
  ThreadTeam team(threads);
  const PlanarCamera desired = bench::viewOfDoorway();
  WarpBuffer buffer;
  buffer.resize(desired.width, desired.height);
  const WarpOptions options{splat, Clip::kTiles, &team};
  const std::vector<glm::vec2> region = testing::wholePicture(desired);
  WarpCounts counts;
  for (auto _ : state) counts = warpLdi(ldi, desired, region, buffer, options);
  state.counters["samples"] = static_cast<double>(counts.samples);
  state.counters["a sample"] = benchmark::Counter(
      static_cast<double>(counts.samples),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The doorway alone, with what cannot be seen through it left out, or not.
void throughTheDoorway(benchmark::State& state, Clip clip) {
  const Ldi& ldi = ldiOf(static_cast<int>(state.range(0)));
  const PlanarCamera desired = bench::viewOfDoorway();
  std::vector<glm::vec2> region;
  for (const glm::vec3& corner : testing::doorway().polygon) {
    region.emplace_back(projectPoint(desired, glm::dvec3(corner)));
  }
  WarpBuffer buffer;
  buffer.resize(desired.width, desired.height);
  WarpCounts counts;
  for (auto _ : state) {
    counts = warpLdi(ldi, desired, region, buffer, {Splat::kMean, clip});
  }
  const auto all = static_cast<double>(ldi.samples.size());
  state.counters["clipped %"] = 100.0 * static_cast<double>(counts.samples_clipped) / all;
}

void addClips() {
  const std::pair<Clip, const char*> clips[] = {{Clip::kNothing, "clip/nothing"},
                                                {Clip::kColumns, "clip/columns"},
                                                {Clip::kTiles, "clip/tiles"}};
  for (const auto& [clip, name] : clips) {
    benchmark::RegisterBenchmark(name,
                                 [clip = clip](benchmark::State& s) { throughTheDoorway(s, clip); })
        ->Arg(256)
        ->Arg(512)
        ->Unit(benchmark::kMicrosecond);
  }
}

void addAll() {
  addClips();
  for (const SplatInfo& info : allSplats()) {
    for (const int rows : {256, 768}) {  // the second has a million samples
      for (const int threads : {1, 2}) {
        benchmark::RegisterBenchmark((std::string("warp/") + info.name).c_str(),
                                     [&](benchmark::State& s) { everySample(s, info.splat); })
            ->Args({rows, threads})
            ->UseRealTime()
            ->Unit(benchmark::kMicrosecond);
      }
    }
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
