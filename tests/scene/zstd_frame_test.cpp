#include "scene/zstd_frame.h"

#include "scene_test_tools.h"

namespace enfilade {
namespace {

TEST(ZstdFrame, GivesBackWhatWasCompressed) {
  const std::vector<std::uint8_t> payload{1, 2, 3, 3, 3, 3};
  EXPECT_EQ(decompressFrame(compressFrame(payload, 3), 6, "a.ldi"), payload);
}

TEST(ZstdFrame, RefusesABombBeforeItAllocates) {
  const std::vector<std::uint8_t> frame(40'000, 0);
  expectError([&] { decompressFrame(frame, std::uint64_t{1} << 30, "a.ldi"); },
              ErrorKind::kBadInput, "a.ldi", "over 512 MiB");
  expectError([&] { decompressFrame(frame, std::uint64_t{1} << 60, "a.ldi"); },
              ErrorKind::kBadInput, "a.ldi", "has sizes that its bytes cannot hold");
}

}  // namespace
}  // namespace enfilade
