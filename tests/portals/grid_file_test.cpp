#include "portals/grid_file.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <cstring>
#include <random>

#include "scene/error.h"

namespace enfilade {
namespace {

using Bytes = std::vector<std::uint8_t>;

CellGrid randomGrid(unsigned seed) {
  std::mt19937 random(seed);
  const glm::ivec3 size(static_cast<int>(random() % 9) + 1, static_cast<int>(random() % 40) + 1,
                        static_cast<int>(random() % 9) + 1);
  std::vector<CellGrid::Label> labels(static_cast<std::size_t>(size.x * size.y * size.z));
  CellGrid::Label label = 0;
  for (CellGrid::Label& l : labels) {
    if (random() % 4 == 0) label = static_cast<CellGrid::Label>(random());
    l = label;
  }
  return {{-1.5f, 2.25f, 1e-3f}, 0.1f, size, labels};
}

void expectSame(const CellGrid& a, const CellGrid& b) {
  EXPECT_EQ(a.origin(), b.origin());
  EXPECT_EQ(a.voxel(), b.voxel());
  EXPECT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::ranges::equal(a.firstRuns(), b.firstRuns()));
  EXPECT_TRUE(std::ranges::equal(a.runs(), b.runs()));
}

/// What the reader says of bytes; empty if it takes them.
std::string complaint(const Bytes& bytes) {
  try {
    decodeGrid(bytes, "some.grid");
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_TRUE(std::string(error.what()).starts_with("some.grid: ")) << error.what();
    return error.what();
  }
}

/// Puts a number into the header and mends the checksum, as a malicious file would.
Bytes withNumber(Bytes bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  std::memcpy(&bytes[at], &value, size);
  Bytes header(bytes.begin(), bytes.begin() + 64);
  std::fill(header.begin() + 56, header.end(), std::uint8_t{0});
  const std::uint64_t sum = XXH3_64bits_withSeed(bytes.data() + 64, bytes.size() - 64,
                                                 XXH3_64bits(header.data(), header.size()));
  std::memcpy(&bytes[56], &sum, 8);
  return bytes;
}

TEST(GridFile, GivesBackWhatWasWritten) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const CellGrid grid = randomGrid(seed);
    const Bytes bytes = encodeGrid(grid);
    EXPECT_EQ(bytes, encodeGrid(grid));
    expectSame(decodeGrid(bytes, "some.grid"), grid);
  }
}

TEST(GridFile, KeepsABuildingSizedGridSmall) {
  std::vector<std::uint32_t> first;
  std::vector<CellGrid::Run> runs;
  for (std::uint32_t column = 0; column <= 1000 * 1000; ++column) first.push_back(column * 3);
  for (int column = 0; column < 1000 * 1000; ++column) {
    const auto room = static_cast<CellGrid::Label>(1 + column % 1000 / 100 + column / 100000 * 10);
    runs.insert(runs.end(), {{1, CellGrid::kSolidVoxel}, {30, room}, {200, kExterior}});
  }
  const CellGrid grid({0, 0, 0}, 0.1f, {1000, 200, 1000}, std::move(first), std::move(runs));
  const Bytes bytes = encodeGrid(grid);
  EXPECT_LT(bytes.size(), 100000u);
  expectSame(decodeGrid(bytes, "some.grid"), grid);
}

TEST(GridFile, RejectsEveryFlippedBit) {
  const Bytes good = encodeGrid(randomGrid(7));
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes bytes = good;
    bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1u << (bit % 8)));
    ASSERT_NE(complaint(bytes), "") << "bit " << bit;
  }
}

TEST(GridFile, RejectsATruncatedFile) {
  const Bytes good = encodeGrid(randomGrid(7));
  for (std::size_t size = 0; size < good.size(); ++size) {
    ASSERT_NE(complaint(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size))), "");
  }
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_NE(complaint(longer), "");
}

TEST(GridFile, RejectsAnotherFormatOrVersion) {
  EXPECT_NE(complaint({'g', 'l', 'T', 'F', 2, 0, 0, 0, 9}).find("not a cell grid"),
            std::string::npos);
  const Bytes other = withNumber(encodeGrid(randomGrid(7)), 8, 2, 4);
  EXPECT_NE(complaint(other).find("version"), std::string::npos);
}

TEST(GridFile, RejectsHostileSizesBeforeAllocatingThem) {
  const CellGrid grid = randomGrid(7);
  const Bytes good = encodeGrid(grid);
  ASSERT_EQ(complaint(withNumber(good, 40, grid.runs().size(), 8)), "");  // the mending is right
  EXPECT_NE(complaint(withNumber(good, 12, 0, 4)), "");
  EXPECT_NE(complaint(withNumber(good, 12, 65536, 4)), "");
  const Bytes wide = withNumber(withNumber(good, 12, 65535, 4), 20, 65535, 4);
  EXPECT_NE(complaint(withNumber(wide, 40, 0xfffe0001u, 8)).find("cannot hold"), std::string::npos);
  EXPECT_NE(complaint(withNumber(good, 40, 0xffffffffu, 8)).find("cannot hold"), std::string::npos);
  EXPECT_NE(complaint(withNumber(good, 40, ~0ull, 8)).find("impossible"), std::string::npos);
  EXPECT_NE(complaint(withNumber(good, 40, ~0ull / 4, 8)).find("impossible"), std::string::npos);
  EXPECT_NE(complaint(withNumber(good, 40, grid.runs().size() + 1, 8)).find("another size"),
            std::string::npos);
  EXPECT_NE(complaint(withNumber(good, 16, 50, 4)).find("fill"), std::string::npos);
  EXPECT_NE(complaint(withNumber(good, 36, 0xffc00000u, 4)).find("voxel"), std::string::npos);
}

}  // namespace
}  // namespace enfilade
