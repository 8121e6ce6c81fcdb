#include "scene/file_io.h"
#include "scene/obj_reader.h"
#include "tests/fuzz/soundness.h"
#include "tests/fuzz/targets.h"

namespace enfilade::fuzz {

void obj(Bytes input) {
  static const std::vector<std::uint8_t> picture =
      readFile(ENFILADE_SOURCE_DIR "/tests/fuzz/beside/dot.png");
  const Bytes text = takePart(input);
  const auto beside = [&](const std::string& name) -> std::optional<std::vector<std::uint8_t>> {
    if (name.ends_with(".png")) return picture;
    if (name.ends_with(".mtl")) return std::vector(input.begin(), input.end());
    return std::nullopt;
  };
  Warnings warnings;
  const Building building = parseObj(text, "model.obj", beside, &warnings);
  for (const std::string& warning : warnings) requireOneLine(warning);
  requireSound(building);
}

}  // namespace enfilade::fuzz
