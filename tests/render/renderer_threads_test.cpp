// The first OSMesa context of a process decides how many threads draw, so each number of threads
// has a process of its own: this program, run again for one test that only then does something.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "render/renderer.h"
#include "scene/file_io.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr const char* kThreads = "ENFILADE_TEST_THREADS";
constexpr const char* kFile = "ENFILADE_TEST_FILE";

TEST(RendererThreads, WritesItsPictureForTheOtherTest) {
  if (std::getenv(kThreads) == nullptr) GTEST_SKIP() << "is run by the test below";
  const auto context = createOsMesaContext(std::atoi(std::getenv(kThreads)));
  const Building building = tunnel();
  Renderer renderer(*context, building);
  renderer.begin(500, 400);
  renderer.draw(allObjects(building), frontCamera(500, 400).view());
  Image image;
  std::vector<float> depth;
  renderer.readColor(image);
  renderer.readDepth(depth);
  std::vector<std::uint8_t> bytes = image.rgba;
  const auto* first = reinterpret_cast<const std::uint8_t*>(depth.data());  // NOLINT
  bytes.insert(bytes.end(), first, first + depth.size() * sizeof(float));
  writeFileAtomically(std::getenv(kFile), bytes);
}

std::vector<std::uint8_t> pictureWith(int threads) {
  const std::string file = (std::filesystem::temp_directory_path() /
                            ("enfilade_threads_" + std::to_string(getpid()) + ".bin"))
                               .string();
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = std::string(kThreads) + "=" + std::to_string(threads) + " " + kFile +
                              "='" + file + "' '" + program +
                              "' --gtest_filter=RendererThreads.Writes* > /dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  const std::vector<std::uint8_t> bytes = readFile(file);
  std::filesystem::remove(file);
  return bytes;
}

TEST(RendererThreads, ThePixelsAreTheSameForAnyNumberOfThreads) {
  const std::vector<std::uint8_t> one = pictureWith(1);
  ASSERT_EQ(one.size(), 500u * 400u * 8u);
  EXPECT_TRUE(pictureWith(2) == one);
  EXPECT_TRUE(pictureWith(3) == one);
}

}  // namespace
}  // namespace enfilade
