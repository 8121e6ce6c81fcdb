#include "ibr/image_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

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
  const std::string_view all = list;
  for (std::size_t first = 0; first <= all.size();) {
    const std::string_view name = all.substr(first, all.find(',', first) - first);
    first += name.size() + 1;
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
