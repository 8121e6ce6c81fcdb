#include "scene/json_depth.h"

#include <nlohmann/json.hpp>

#include "scene/camera_path.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonDepth, IsRefusedBeyondAHundred) {
  EXPECT_NO_THROW(requireShallowJson(nested(100), "a.json"));
  expectError([] { requireShallowJson(nested(101), "a.json"); }, ErrorKind::kBadInput, "a.json",
              "nests its JSON deeper than 100");
}

TEST(JsonDepth, IsNotCountedInStrings) {
  EXPECT_NO_THROW(requireShallowJson("[\"" + std::string(200, '[') + "\\\"[\", 1]", "a.json"));
  EXPECT_NO_THROW(
      requireShallowJson(nlohmann::json(std::vector<std::string>(500, "[")).dump(), "a.json"));
}

TEST(JsonDepth, IsRefusedInATourWhichCopiesWhatIsThere) {
  const std::string text = R"({"enfilade": "tour", "version": 1, "frames": [{"t": 0,
      "p": [0, 0, 0], "q": [0, 0, 0, 1]}], "doors": [{"t": )" +
                           nested(100'000) + "}]}";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  expectError(
      [&] {
        decodeCameraPath({bytes, text.size()}, "tour.json");
      },
      ErrorKind::kBadInput, "tour.json", "nests its JSON deeper than 100");
}

}  // namespace
}  // namespace enfilade
