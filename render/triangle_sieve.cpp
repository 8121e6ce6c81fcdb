#include "render/triangle_sieve.h"

#include <algorithm>
#include <cmath>

#include "render/allowed_threads.h"
#include "render/share_out.h"

namespace enfilade {

namespace {

constexpr std::size_t kPiece = 4096;    // [triangles] sifted at once
constexpr std::size_t kShared = 60000;  // [triangles] fewer are not worth another thread
constexpr int kOccluder = 5 * OcclusionGrid::kSide;  // [pixels] smaller ones hide little

/// A difference of depth buffer values that no rounding of the rasteriser's makes up: some 80
/// units in the last place of 1.
constexpr double kDepthSlack = 1e-5;

}  // namespace

TriangleSieve::TriangleSieve(const WorldGeometry& world)
    : world_indices_(world.indices), ranges_(world.objects.size()) {
  const std::size_t count = world_indices_.size() / 3;
  const std::size_t stride = count + kSieveSlack;
  coordinates_.resize(9 * stride, 0.0f);
  for (std::size_t c = 0; c < 9; ++c) {
    float* coordinate = &coordinates_[c * stride];
    corners_[c] = coordinate;
    for (std::size_t t = 0; t < count; ++t) {
      const WorldVertex& vertex = world.vertices[world_indices_[3 * t + c / 3]];
      coordinate[t] = vertex.position[static_cast<glm::length_t>(c % 3)];
    }
  }
  for (const IndexRange& object : world.objects) {
    Extent extent{object.first / 3, object.count / 3};
    for (std::size_t i = object.first; i < object.first + object.count; ++i) {
      extent.reach = glm::max(extent.reach, glm::abs(world.vertices[world_indices_[i]].position));
    }
    extents_.push_back(extent);
  }
}

void TriangleSieve::plan(std::span<const SieveObject> objects) {
  pieces_.clear();
  slots_ = 0;
  for (const SieveObject& object : objects) {
    const Extent& extent = extents_[object.object];
    Piece piece;
    piece.object = &object;
    piece.rows = sieveRows(view_, extent.reach, !object.double_sided);
    piece.depth_rounding = depthRounding(view_, extent.reach);
    for (std::size_t done = 0; done < extent.count; done += kPiece) {
      piece.first = extent.first + done;
      piece.count = std::min(kPiece, extent.count - done);
      piece.slot = slots_;
      slots_ += piece.count + kSieveSlack;
      pieces_.push_back(piece);
    }
  }
  if (kept_.size() < slots_) {
    kept_.resize(slots_);
    boxes_.resize(4 * slots_);
    nearest_.resize(slots_);
    indices_.resize(3 * slots_);
  }
}

SieveOutput TriangleSieve::output(std::size_t slot) noexcept {
  const std::size_t stride = kept_.size();
  std::int32_t* box = &boxes_[slot];
  return {&kept_[slot], box, box + stride, box + 2 * stride, box + 3 * stride, &nearest_[slot]};
}

void TriangleSieve::addOccluders(const Piece& piece) noexcept {
  const SieveRows& rows = piece.rows;
  const SieveOutput kept = output(piece.slot);
  for (std::size_t i = 0; i < piece.kept; ++i) {
    if (kept.x1[i] - kept.x0[i] < kOccluder || kept.y1[i] - kept.y0[i] < kOccluder) continue;
    OcclusionGrid::Corners corners;
    for (std::size_t c = 0; c < 3; ++c) {
      glm::dvec4 p(1);
      for (std::size_t k = 0; k < 3; ++k) {
        p[static_cast<glm::length_t>(k)] = corners_[3 * c + k][kept.triangle[i]];
      }
      corners[c] = {glm::dot(glm::dvec4(rows.x), p), glm::dot(glm::dvec4(rows.y), p),
                    glm::dot(glm::dvec4(rows.w), p)};
    }
    if (rows.drops_counter && glm::dot(corners[0], glm::cross(corners[1], corners[2])) >= 0)
      continue;
    const double least_w =
        std::max(std::min({corners[0].z, corners[1].z, corners[2].z}), 1 / depths_.nearest);
    OcclusionGrid::Limits limits;
    limits.slack = 2 * rows.snapping + 4 * rows.rounding / least_w;
    limits.nearest = 0.999 * depths_.nearest;
    limits.factor = 1 + 2 * piece.depth_rounding / depths_.factor;
    limits.less = -2 * kDepthSlack / depths_.factor;
    grid_.add(corners, limits, kept.y0[i], kept.y1[i]);
  }
}

void TriangleSieve::write(const Piece& piece) noexcept {
  const SieveOutput kept = output(piece.slot);
  const auto factor = static_cast<float>(1 - 2 * piece.depth_rounding / depths_.factor);
  const auto more = static_cast<float>(-2 * kDepthSlack / depths_.factor);
  for (std::size_t i = 0; i < piece.kept; ++i) {
    if (depths_.known && grid_.hides(kept.x0[i], kept.y0[i], kept.x1[i], kept.y1[i],
                                     factor * kept.nearest[i] + more)) {
      continue;
    }
    const std::uint32_t* from = &world_indices_[3 * std::size_t{kept.triangle[i]}];
    std::copy(from, from + 3, &indices_[used_]);
    used_ += 3;
  }
}

void TriangleSieve::sift(std::span<const SieveObject> objects, const SieveView& view, int threads) {
  view_ = view;
  depths_ = depthRange(view.clip_from_world);
  plan(objects);
  if (slots_ < kShared) threads = 1;
  if (threads <= 0) threads = allowedThreads();
  shareOut(pieces_.size(), threads, [&](std::size_t i) {
    Piece& piece = pieces_[i];
    piece.kept = siftTriangles(corners_, piece.first, piece.count, piece.rows, output(piece.slot));
  });
  if (depths_.known) {
    grid_.start(view.width, view.height);
    for (const Piece& piece : pieces_) {
      if (piece.object->opaque) addOccluders(piece);
    }
  }
  used_ = 0;
  for (const SieveObject& object : objects) ranges_[object.object] = {0, 0};
  for (const Piece& piece : pieces_) {
    IndexRange& range = ranges_[piece.object->object];
    if (range.count == 0) range.first = used_;
    write(piece);
    range.count = static_cast<std::uint32_t>(used_ - range.first);
  }
}

}  // namespace enfilade
