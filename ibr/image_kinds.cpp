#include "ibr/image_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/error.h"

namespace enfilade {
namespace {

struct NamedKind {
  bool ImageKinds::*kind;
  const char* name;
};
constexpr std::array<NamedKind, 3> kKindNames = {{{&ImageKinds::textures, "texture"},
                                                  {&ImageKinds::references, "warp"},
                                                  {&ImageKinds::ldis, "ldi"}}};

}  // namespace

std::string imageKindNames(const ImageKinds& kinds) {
  std::string names;
  for (const NamedKind& named : kKindNames) {
    if (kinds.*named.kind) names += (names.empty() ? "" : ",") + std::string(named.name);
  }
  return names;
}

ImageKinds parseImageKinds(const std::string& list) {
  ImageKinds kinds{false, false, false};
  for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
    end = list.find(',', at);
    const std::string name = list.substr(at, end - at);
    const auto* const named =
        std::find_if(kKindNames.begin(), kKindNames.end(),
                     [&](const NamedKind& known) { return name == known.name; });
    if (named == kKindNames.end()) {
      throw Error(ErrorKind::kUsage, fmt::format("'{}'", name),
                  "no such kind of image; there are: texture, warp, ldi");
    }
    kinds.*named->kind = true;
  }
  return kinds;
}

std::string ldiFileName() { return "ldi.bin"; }
std::string textureFileName(std::size_t index) { return fmt::format("texture-{:02}.png", index); }
std::string referenceFileName(std::size_t index) {
  return fmt::format("reference-{:02}.bin", index);
}

}  // namespace enfilade
