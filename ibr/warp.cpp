// McMillan & Bishop, Plenoptic Modeling, 1995; Rafferty et al., Images for Accelerating
// Architectural Walkthroughs, 1998, sec. 3.
#include "ibr/warp.h"

#include <algorithm>

#include "ibr/region_warp.h"
#include "ibr/warp_scratch.h"
#include "render/thread_team.h"

namespace enfilade {
namespace {

/// Tiles that are tried against a region by one thread, one after another.
constexpr std::size_t kTilesTogether = 512;
/// Smaller fragments are not worth a thread of their own.
constexpr std::size_t kLeastSamples = 8192;

/// Warps of some jobs, in four rounds of work that is shared out.
class WarpRounds {
 public:
  WarpRounds(std::span<WarpJob> jobs, const PlanarCamera& desired, const WarpOptions& options,
             WarpAgenda& agenda) noexcept
      : jobs_(jobs), desired_(desired), options_(options), agenda_(agenda) {
    if (agenda_.plans.size() < jobs.size()) agenda_.plans.resize(jobs.size());
  }

  void run() noexcept {
    share(jobs_.size(), [&](std::size_t i) { warpOf(i).begin(); });
    clip();
    share(jobs_.size(), [&](std::size_t i) { warpOf(i).countSamples(); });
    cut();
    warp();
    for (std::size_t i = 0; i < jobs_.size(); ++i) warpOf(i).countPixels();
  }

 private:
  RegionWarp warpOf(std::size_t i) noexcept {
    return {desired_, jobs_[i], options_, agenda_.plans[i]};
  }

  template <class Body>
  void share(std::size_t count, const Body& body) noexcept {
    if (options_.team != nullptr) {
      options_.team->run(count, body);
    } else {
      for (std::size_t i = 0; i < count; ++i) body(i);
    }
  }

  template <class Body>
  void shareParts(const Body& body) noexcept {
    share(agenda_.parts.size(), [&](std::size_t i) { body(agenda_.parts[i]); });
  }

  void clip() noexcept {
    agenda_.parts.clear();
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const std::size_t tiles = agenda_.plans[i].boxes.size();
      const std::size_t step = options_.clip == Clip::kTiles ? kTilesTogether : tiles;
      for (std::size_t first = 0; first < tiles; first += step) {
        agenda_.parts.push_back({i, first, std::min(first + step, tiles)});
      }
    }
    shareParts([&](const WarpAgenda::Part& p) { warpOf(p.job).clipTiles(p.first, p.beyond); });
  }

  /// Fragments in proportion to a job's samples, so that all of the team has work.
  void cut() noexcept {
    std::size_t all = 1;
    for (const WarpJob& job : jobs_) all += job.counts.samples;
    const auto threads =
        static_cast<std::size_t>(options_.team != nullptr ? options_.team->size() : 0);
    share(jobs_.size(), [&](std::size_t i) {
      const std::size_t samples = jobs_[i].counts.samples;
      const std::size_t share_of_all = (threads * samples + all / 2) / all;
      warpOf(i).cut(std::min(share_of_all, samples / kLeastSamples));
    });
  }

  void warp() noexcept {
    agenda_.parts.clear();
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      for (std::size_t f = 0; f < agenda_.plans[i].fragment_count; ++f) {
        agenda_.parts.push_back({i, f, f + 1});
      }
    }
    shareParts([&](const WarpAgenda::Part& p) { warpOf(p.job).warpFragment(p.first); });
  }

  std::span<WarpJob> jobs_;
  const PlanarCamera& desired_;
  const WarpOptions& options_;
  WarpAgenda& agenda_;
};

}  // namespace

WarpCounts& WarpCounts::operator+=(const WarpCounts& more) noexcept {
  samples += more.samples;
  samples_clipped += more.samples_clipped;
  pixels += more.pixels;
  pixels_uncovered += more.pixels_uncovered;
  pixels_bridged += more.pixels_bridged;
  return *this;
}

WarpBuffer::WarpBuffer(std::shared_ptr<WarpScratch> scratch)
    : scratch_(scratch ? std::move(scratch) : std::make_shared<WarpScratch>()) {}

void WarpBuffer::resize(int width, int height) {
  color.width = width;
  color.height = height;
  color.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
}

void warpJobs(std::span<WarpJob> jobs, const PlanarCamera& desired,
              const WarpOptions& options) noexcept {
  if (jobs.empty()) return;
  const Pool<WarpAgenda>::Lease agenda(jobs[0].target->scratch().agendas);
  WarpRounds(jobs, desired, options, *agenda).run();
}

WarpCounts warpImages(std::span<const Ldi* const> images, const PlanarCamera& desired,
                      std::span<const glm::vec2> region, WarpBuffer& target,
                      const WarpOptions& options) noexcept {
  WarpJob job{images, region, &target, {}};
  warpJobs({&job, 1}, desired, options);
  return job.counts;
}

WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> region,
                   WarpBuffer& target, const WarpOptions& options) noexcept {
  const Ldi* const image = &ldi;
  return warpImages({&image, 1}, desired, region, target, options);
}

}  // namespace enfilade
