// Reads every input of the fuzzers' corpora, among them all that once were findings, as a plain
// test: without libFuzzer, by any compiler.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>

#include "scene/error.h"
#include "scene/file_io.h"
#include "tests/fuzz/targets.h"

namespace enfilade::fuzz {

std::span<const Target> allTargets() {
  static constexpr std::array<Target, 16> kTargets{{
      {"camera_gltf", camera_gltf},
      {"catalogue", catalogue},
      {"doors", doors},
      {"given_graph", given_graph},
      {"glb", glb},
      {"gltf", gltf},
      {"grid", grid},
      {"house_json", house_json},
      {"image", image},
      {"ldi", ldi},
      {"obj", obj},
      {"plan", plan},
      {"report", report},
      {"settings", settings},
      {"tour", tour},
      {"tum", tum},
  }};
  return kTargets;
}

namespace {

namespace fs = std::filesystem;

fs::path corpusOf(std::string_view target) {
  return fs::path(ENFILADE_SOURCE_DIR) / "tests/fuzz/corpus" / target;
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, IsReadOrRefusedWithAnError) {
  int read = 0;
  int refused = 0;
  for (const auto& entry : fs::directory_iterator(corpusOf(GetParam().name))) {
    SCOPED_TRACE(entry.path());
    const std::vector<std::uint8_t> input = readFile(entry.path().string());
    try {
      GetParam().read(input);
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    } catch (const std::exception& other) {
      ADD_FAILURE() << other.what();
    }
  }
  EXPECT_GE(read, 1) << "a corpus needs an input that is right, to begin from";
  RecordProperty("read", read);
  RecordProperty("refused", refused);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(allTargets().begin(), allTargets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(Corpora, HaveATargetEach) {
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(corpusOf(""))) folders += entry.is_directory();
  EXPECT_EQ(folders, allTargets().size());
}

}  // namespace
}  // namespace enfilade::fuzz
