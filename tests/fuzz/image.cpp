#include "scene/image.h"

#include "tests/fuzz/soundness.h"
#include "tests/fuzz/targets.h"

namespace enfilade::fuzz {

void image(Bytes input) {
  const Image picture = decodeImage({input.begin(), input.end()}, "picture");
  require(picture.width > 0 && picture.height > 0 &&
              picture.rgba.size() == std::size_t{4} * static_cast<std::size_t>(picture.width) *
                                         static_cast<std::size_t>(picture.height),
          "all pixels are there");
}

}  // namespace enfilade::fuzz
