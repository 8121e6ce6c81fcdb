#include "analytic_scene.h"

#include <algorithm>
#include <cmath>

#include "ibr/convex_region.h"

namespace enfilade::testing {
namespace {

double hashed(std::int64_t x, std::int64_t y, std::int64_t z) {
  auto h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u ^
           static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu ^
           static_cast<std::uint64_t>(z) * 0x165667B19E3779F9u;
  h = (h ^ h >> 31) * 0xBF58476D1CE4E5B9u;
  h = (h ^ h >> 29) * 0x94D049BB133111EBu;
  return static_cast<double>((h ^ h >> 32) >> 11) * 0x1p-53;
}

/// Smooth noise with cells of 1.
double noise(const glm::dvec3& p) {
  const glm::dvec3 cell = glm::floor(p);
  const glm::dvec3 f = p - cell;
  const glm::dvec3 s = f * f * (3.0 - 2.0 * f);
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner(i & 1, i >> 1 & 1, i >> 2);
    const glm::dvec3 w = corner * s + (1.0 - corner) * (1.0 - s);
    const glm::dvec3 at = cell + corner;
    sum += w.x * w.y * w.z * hashed(std::llround(at.x), std::llround(at.y), std::llround(at.z));
  }
  return sum;
}

glm::dvec3 surfaceColor(const SolidBox& box, const glm::dvec3& p, int axis) {
  // Noise of two sizes and tiles of 15 cm.
  const double value = 0.5 * noise(p / 0.03) + 0.5 * noise(p / 0.12);
  const glm::dvec3 tile = glm::floor((p + 1e-4) / 0.15);
  const double check = std::fmod(std::abs(tile.x + tile.y + tile.z), 2.0);
  const double light = (axis == 1 ? 1.0 : axis == 0 ? 0.85 : 0.7);
  return glm::clamp(box.color * light * (1.0 + box.contrast * (value - 0.6 + 0.25 * check)), 0.0,
                    1.0);
}

}  // namespace

AnalyticScene::Hit AnalyticScene::cast(const glm::dvec3& origin, const glm::dvec3& direction,
                                       double least) const {
  Hit hit{-1.0, glm::dvec3(0.70, 0.80, 0.92)};
  for (const SolidBox& box : boxes) {
    const glm::dvec3 a = (box.min - origin) / direction;
    const glm::dvec3 b = (box.max - origin) / direction;
    const glm::dvec3 enter = glm::min(a, b);
    const glm::dvec3 leave = glm::max(a, b);
    const double t0 = std::max({enter.x, enter.y, enter.z});
    const double t1 = std::min({leave.x, leave.y, leave.z});
    if (!(t0 <= t1)) {
      continue;
    }
    const double t = box.inside_out ? t1 : t0;
    if (t > least && (hit.t < 0 || t < hit.t)) {
      const glm::dvec3& faces = box.inside_out ? leave : enter;
      const int axis = t == faces.x ? 0 : t == faces.y ? 1 : 2;
      hit = {t, surfaceColor(box, origin + t * direction, axis)};
    }
  }
  return hit;
}

AnalyticScene furnishedRoom() {
  AnalyticScene scene;
  const auto add = [&](glm::dvec3 min, glm::dvec3 size, glm::dvec3 color, double contrast = 0.6) {
    scene.boxes.push_back({min, min + size, color, contrast, false});
  };
  scene.boxes.push_back({{-2.2, 0, -4.1}, {2.8, 2.8, -0.1}, {0.8, 0.75, 0.65}, 0.5, true});
  // The wall's half behind the doorway's plane: jambs, lintel, threshold.
  add({-2.2, 0, -0.1}, {1.7, 2.8, 0.1}, {0.6, 0.6, 0.7});
  add({0.5, 0, -0.1}, {2.3, 2.8, 0.1}, {0.6, 0.6, 0.7});
  add({-0.5, 2.1, -0.1}, {1.0, 0.7, 0.1}, {0.6, 0.6, 0.7});
  add({-0.5, -0.1, -0.1}, {1.0, 0.1, 0.1}, {0.4, 0.3, 0.3});
  // A table with four legs, chairs, a shelf with books, a pillar, a lamp, pictures.
  add({-0.9, 0.72, -2.6}, {1.6, 0.05, 0.9}, {0.6, 0.4, 0.2});
  for (const double x : {-0.85, 0.6}) {
    for (const double z : {-2.55, -1.8}) {
      add({x, 0, z}, {0.06, 0.72, 0.06}, {0.5, 0.3, 0.15});
    }
  }
  for (const double x : {-0.7, 0.1}) {
    add({x, 0.42, -1.6}, {0.42, 0.04, 0.42}, {0.3, 0.4, 0.6});
    add({x, 0.0, -1.6}, {0.04, 0.95, 0.04}, {0.3, 0.3, 0.5});
    add({x + 0.38, 0.0, -1.6}, {0.04, 0.95, 0.04}, {0.3, 0.3, 0.5});
    add({x, 0.7, -1.6}, {0.42, 0.25, 0.03}, {0.3, 0.4, 0.6});
  }
  add({-0.2, 0.77, -2.3}, {0.15, 0.25, 0.15}, {0.9, 0.3, 0.2});
  add({0.2, 0.77, -2.1}, {0.3, 0.04, 0.2}, {0.2, 0.7, 0.3});
  add({2.3, 0, -3.6}, {0.5, 2.1, 0.03}, {0.45, 0.3, 0.2});
  add({2.3, 0, -1.5}, {0.5, 2.1, 0.03}, {0.45, 0.3, 0.2});
  for (int shelf = 0; shelf < 6; ++shelf) {
    const double y = 0.1 + 0.38 * shelf;
    add({2.3, y, -3.6}, {0.5, 0.03, 2.1}, {0.45, 0.3, 0.2});
    for (int book = 0; book < 30 && shelf < 5; ++book) {
      const double r = hashed(book, shelf, 7);
      add({2.45 + 0.05 * r, y + 0.03, -3.55 + 0.068 * book}, {0.3, 0.2 + 0.12 * r, 0.055},
          {hashed(book, shelf, 1), hashed(book, shelf, 2), hashed(book, shelf, 3)});
    }
  }
  add({-1.6, 0, -3.2}, {0.3, 2.8, 0.3}, {0.75, 0.75, 0.7});
  add({-0.3, 1.9, -2.3}, {0.4, 0.25, 0.4}, {0.95, 0.9, 0.6});
  add({-1.2, 1.2, -4.1}, {1.0, 0.7, 0.04}, {0.8, 0.2, 0.2}, 0.9);
  add({0.3, 1.1, -4.1}, {0.8, 0.9, 0.04}, {0.2, 0.4, 0.8}, 0.9);
  return scene;
}

Portal doorway() {
  Portal portal;
  portal.name = "doorway";
  portal.polygon = {{-0.5f, 0, 0}, {0.5f, 0, 0}, {0.5f, 2.1f, 0}, {-0.5f, 2.1f, 0}};
  portal.plane = {{0, 0, 1}, 0};
  portal.front = 1;
  portal.back = 2;
  return portal;
}

namespace {

/// A picture of the sky without pixels that are known.
DepthImage unknownImage(const PlanarCamera& camera) {
  DepthImage image;
  image.camera = camera;
  image.color.width = camera.width;
  image.color.height = camera.height;
  const auto pixels =
      static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  image.color.rgba.assign(4 * pixels, 255);
  image.disparity.assign(pixels, 0.0f);
  return image;
}

void setPixel(DepthImage& image, int x, int y, const AnalyticScene::Hit& hit) {
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.camera.width) +
                     static_cast<std::size_t>(x);
  image.disparity[pixel] = hit.t > 0 ? static_cast<float>(1.0 / hit.t) : 1e-3f;
  for (int c = 0; c < 3; ++c) {
    image.color.rgba[4 * pixel + static_cast<std::size_t>(c)] =
        static_cast<std::uint8_t>(hit.color[c] * 255.0 + 0.5);
  }
}

glm::dvec3 rayOf(const PlanarCamera& camera, int x, int y) {
  return camera.world_from_pixel * glm::dvec3(x + 0.5, y + 0.5, 1);
}

}  // namespace

DepthImage castImage(const AnalyticScene& scene, const PlanarCamera& camera) {
  DepthImage image = unknownImage(camera);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      setPixel(image, x, y, scene.cast(camera.center, rayOf(camera, x, y), 1.0));
    }
  }
  return image;
}

DepthImage castThroughDoorway(const AnalyticScene& scene, const PlanarCamera& camera,
                              std::span<const glm::vec2> region) {
  DepthImage image = unknownImage(camera);
  std::vector<glm::ivec2> spans(static_cast<std::size_t>(camera.height), glm::ivec2(0));
  fillConvexPolygon(region, camera.width, camera.height, spans);
  for (int y = 0; y < camera.height; ++y) {
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    for (int x = span.x; x < span.y; ++x) {
      const glm::dvec3 ray = rayOf(camera, x, y);
      setPixel(image, x, y, scene.cast(camera.center, ray, -camera.center.z / ray.z));
    }
  }
  return image;
}

}  // namespace enfilade::testing
