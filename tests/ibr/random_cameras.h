#pragma once

#include <random>

#include "ibr/ldi_builder.h"
#include "ibr/planar_camera.h"
#include "scene/camera.h"

namespace enfilade::testing {

/// Random numbers that are the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int operator()(int low, int beyond) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(beyond - low));
  }

 private:
  std::mt19937 engine_;
};

/// A camera at `eye` that looks at `target`, 60° high.
inline PlanarCamera desiredCamera(const glm::dvec3& eye, const glm::dvec3& target, int width,
                                  int height) {
  Camera camera;
  camera.pose = lookAt(glm::vec3(eye), glm::vec3(target));
  camera.aspect = static_cast<float>(width) / static_cast<float>(height);
  return planarCamera(camera, width, height);
}

/// Looks from 1.5 m before the plane z = 0 through the rectangle of the doorway in it.
inline PlanarCamera referenceCamera(int rows) {
  PlanarCamera camera;
  camera.center = {0, 1.6, 1.5};
  camera.height = rows;
  camera.width = rows / 2;
  camera.world_from_pixel =
      glm::dmat3({1.0 / camera.width, 0, 0}, {0, -2.1 / rows, 0}, {-0.5, 0.5, -1.5});
  return camera;
}

/// An LDI of samples anywhere, no two of one surface.
inline Ldi randomLdi(Random& random, int samples) {
  LdiBuilder builder(referenceCamera(64), {0.0f, 4.0f});
  CaptureSamples capture;
  capture.camera = referenceCamera(64);
  for (int i = 0; i < samples; ++i) {
    CaptureSample s;
    s.u = static_cast<float>(random(-40.0, 72.0));
    s.v = static_cast<float>(random(-40.0, 104.0));
    s.disparity = static_cast<float>(std::pow(random(0.05, 1.0), 2));
    s.r = static_cast<std::uint8_t>(random(0, 256));
    s.g = static_cast<std::uint8_t>(random(0, 256));
    s.b = static_cast<std::uint8_t>(random(0, 256));
    capture.samples.push_back(s);
  }
  builder.insert(capture);
  return builder.finish();
}

/// Where a sample was seen, exactly as stored: pixel of the LDI, and disparity.
inline glm::dvec3 storedPlace(const LdiTile& tile, const LdiSample& sample) {
  return {tile.x * kLdiTile + static_cast<double>(xInTile(sample)),
          tile.y * kLdiTile + static_cast<double>(yInTile(sample)),
          static_cast<double>(disparityOf(sample))};
}

/// The polygon of the whole picture.
inline std::vector<glm::vec2> wholePicture(const PlanarCamera& camera) {
  const auto w = static_cast<float>(camera.width);
  const auto h = static_cast<float>(camera.height);
  return {{0, 0}, {w, 0}, {w, h}, {0, h}};
}

}  // namespace enfilade::testing
