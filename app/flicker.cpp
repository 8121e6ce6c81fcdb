#include "app/flicker.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "render/parallel_for.h"

namespace enfilade {

namespace {

constexpr double kSameDepth = 0.02;  ///< by which a surface's depth may differ, as a share
constexpr glm::vec2 kNotInSight(-1, -1);

/// The four pixels around a place, and the weights of a bilinear mean.
struct Taps {
  std::array<std::size_t, 4> pixels;
  std::array<float, 4> weights;
};

Taps tapsAt(const glm::vec2& place, int width, int height) {
  const glm::ivec2 beyond(place + 0.5f);  // the place is not negative
  const glm::vec2 t = place + 0.5f - glm::vec2(beyond);
  const auto x0 = static_cast<std::size_t>(std::max(beyond.x - 1, 0));
  const auto y0 = static_cast<std::size_t>(std::max(beyond.y - 1, 0));
  const auto x1 = static_cast<std::size_t>(std::min(beyond.x, width - 1));
  const auto y1 = static_cast<std::size_t>(std::min(beyond.y, height - 1));
  const auto w = static_cast<std::size_t>(width);
  return {{y0 * w + x0, y0 * w + x1, y1 * w + x0, y1 * w + x1},
          {(1 - t.x) * (1 - t.y), t.x * (1 - t.y), (1 - t.x) * t.y, t.x * t.y}};
}

/// Distance before the eye [m] of an OpenGL depth 0…1.
double eyeDepth(const Camera& camera, double depth) {
  const auto n = static_cast<double>(camera.near_plane);
  const auto f = static_cast<double>(camera.far_plane);
  return n * f / (f - depth * (f - n));
}

/// The OpenGL depth of a distance before the eye [m].
double glDepth(const Camera& camera, double distance) {
  const auto n = static_cast<double>(camera.near_plane);
  const auto f = static_cast<double>(camera.far_plane);
  return (f - n * f / distance) / (f - n);
}

/// `before` where a point of the frame now was, `clip` its clip coordinates there.
glm::vec2 placeBefore(const glm::dvec4& clip, const DepthView& before, int width, int height) {
  if (clip.w <= 0) return kNotInSight;
  const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
  const glm::vec2 place(0.5 * (1 + ndc.x) * width, 0.5 * (1 - ndc.y) * height);
  const bool inside = place.x >= 0 && place.y >= 0 && place.x <= static_cast<float>(width) &&
                      place.y <= static_cast<float>(height);
  if (!inside) return kNotInSight;
  const double own = eyeDepth(before.camera, std::min(0.5 + 0.5 * ndc.z, 1.0));
  const auto least = static_cast<float>(glDepth(before.camera, own * (1 - kSameDepth)));
  const auto most = static_cast<float>(glDepth(before.camera, own * (1 + kSameDepth)));
  for (const std::size_t pixel : tapsAt(place, width, height).pixels) {
    if (least <= before.depth[pixel] && before.depth[pixel] <= most) return place;
  }
  return kNotInSight;
}

bool isZero(const PictureError& error) {
  return std::all_of(error.begin(), error.end(),
                     [](const glm::i16vec3& e) { return e == glm::i16vec3(0); });
}

/// What a row comes to.
struct RowSum {
  double levels = 0;
  std::size_t pixels = 0;
};

double changeOfError(const glm::i16vec3& now, const PictureError& before, const Taps& taps) {
  glm::vec3 was(0);
  for (std::size_t k = 0; k < 4; ++k) was += taps.weights[k] * glm::vec3(before[taps.pixels[k]]);
  const glm::vec3 change = glm::abs(glm::vec3(now) - was);
  return static_cast<double>(change.r + change.g + change.b) / 3.0;
}

}  // namespace

FrameMotion motionBetween(const DepthView& before, const DepthView& now, int width, int height) {
  FrameMotion motion{width, height, {}};
  motion.before.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  assert(before.depth.size() == motion.before.size() && now.depth.size() == motion.before.size());
  const glm::dmat4 before_from_now = glm::dmat4(before.camera.clipFromWorld()) *
                                     glm::inverse(glm::dmat4(now.camera.clipFromWorld()));
  parallelFor(static_cast<std::size_t>(height), [&](std::size_t row) {
    const std::size_t first = row * static_cast<std::size_t>(width);
    const auto y = static_cast<double>(row);
    for (int x = 0; x < width; ++x) {
      const std::size_t pixel = first + static_cast<std::size_t>(x);
      const glm::dvec4 ndc(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height,
                           2 * static_cast<double>(now.depth[pixel]) - 1, 1);
      motion.before[pixel] = placeBefore(before_from_now * ndc, before, width, height);
    }
  });
  return motion;
}

void errorOf(const Image& picture, const Image& truth, PictureError& out) {
  assert(picture.rgba.size() == truth.rgba.size());
  out.resize(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const std::size_t at = 4 * i + static_cast<std::size_t>(c);
      out[i][c] = static_cast<std::int16_t>(picture.rgba[at] - truth.rgba[at]);
    }
  }
}

std::optional<double> flicker(const FrameMotion& motion, const PictureError& now,
                              const PictureError& before) {
  assert(now.size() == motion.before.size() && before.size() == now.size());
  std::vector<RowSum> rows(static_cast<std::size_t>(motion.height));
  const auto width = static_cast<std::size_t>(motion.width);
  const bool nothing_changes = isZero(now) && isZero(before);
  parallelFor(rows.size(), [&](std::size_t y) {
    for (std::size_t pixel = y * width; pixel < (y + 1) * width; ++pixel) {
      const glm::vec2 place = motion.before[pixel];
      if (place.x < 0) continue;
      ++rows[y].pixels;
      if (nothing_changes) continue;
      rows[y].levels +=
          changeOfError(now[pixel], before, tapsAt(place, motion.width, motion.height));
    }
  });
  RowSum total;
  for (const RowSum& row : rows) {
    total.levels += row.levels;
    total.pixels += row.pixels;
  }
  if (total.pixels == 0) return std::nullopt;
  return total.levels / static_cast<double>(total.pixels);
}

}  // namespace enfilade
