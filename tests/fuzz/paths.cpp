#include "scene/camera_path.h"
#include "tests/fuzz/containers.h"
#include "tests/fuzz/soundness.h"

namespace enfilade::fuzz {
namespace {

void readPath(Bytes bytes) {
  requireSound(decodeCameraPath(bytes, ENFILADE_SOURCE_DIR "/tests/fuzz/beside/path.gltf", 30.0));
}

}  // namespace

void tour(Bytes input) { readPath(input); }

void tum(Bytes input) { readPath(input); }

void camera_gltf(Bytes input) {
  const bool is_json = !input.empty() && input.back() == '}';
  readPath(is_json ? std::vector(input.begin(), input.end()) : glbOf(input));
}

}  // namespace enfilade::fuzz
