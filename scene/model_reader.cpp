#include "scene/model_reader.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "scene/obj_reader.h"

namespace enfilade {

namespace {

/// How a file begins; nothing of one that cannot be read, which its reader will say.
std::vector<std::uint8_t> beginningOf(const std::string& file) {
  std::vector<std::uint8_t> bytes(65536);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), std::ssize(bytes));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return bytes;
}

}  // namespace

Building readModel(const std::string& file, Warnings* warnings) {
  return looksLikeObj(beginningOf(file)) ? readObj(file, warnings) : readGltf(file, warnings);
}

}  // namespace enfilade
