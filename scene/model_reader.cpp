#include "scene/model_reader.h"

#include <vector>

#include "scene/file_io.h"
#include "scene/gltf_reader.h"
#include "scene/obj_reader.h"

namespace enfilade {

namespace {

/// How a file begins; nothing of one that cannot be read, which its reader will say.
std::vector<std::uint8_t> beginningOf(const std::string& file) {
  return readFileStart(file, 65536);
}

}  // namespace

Building readModel(const std::string& file, Warnings* warnings) {
  return looksLikeObj(beginningOf(file)) ? readObj(file, warnings) : readGltf(file, warnings);
}

}  // namespace enfilade
