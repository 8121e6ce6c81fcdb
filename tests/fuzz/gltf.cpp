#include "scene/gltf_reader.h"
#include "tests/fuzz/containers.h"
#include "tests/fuzz/soundness.h"

namespace enfilade::fuzz {
namespace {

/// What a model names is looked for beside this.
const char* const kModel = ENFILADE_SOURCE_DIR "/tests/fuzz/beside/model.gltf";

void readModel(Bytes bytes) {
  Warnings warnings;
  const Building building = decodeGltf(bytes, kModel, &warnings);
  for (const std::string& warning : warnings) requireOneLine(warning);
  requireSound(building);
}

}  // namespace

void gltf(Bytes input) { readModel(input); }

void glb(Bytes input) { readModel(glbOf(input)); }

}  // namespace enfilade::fuzz
