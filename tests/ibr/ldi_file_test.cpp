#include "ibr/ldi_file.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <xxhash.h>

#include <cstring>
#include <filesystem>

#include "random_cameras.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/zstd_frame.h"

namespace enfilade {
namespace {

constexpr std::size_t kHeader = 144;
constexpr std::size_t kChecksumAt = 40;

class LdiFile : public ::testing::Test {
 protected:
  LdiFile() {
    testing::Random random(9);
    ldi_ = testing::randomLdi(random, 500);
    file_ = (std::filesystem::temp_directory_path() /
             ("enfilade-ldi-" + std::to_string(::getpid()) + ".bin"))
                .string();
    writeLdi(file_, ldi_);
    bytes_ = readFile(file_);
    payload_ = decompressFrame(std::span<const std::uint8_t>(bytes_).subspan(kHeader),
                               8 * (ldi_.tiles.size() + ldi_.samples.size()), file_);
  }
  ~LdiFile() override { std::filesystem::remove(file_); }

  template <class T>
  T at(std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof(T));
    return value;
  }
  template <class T>
  void put(std::size_t offset, T value) {
    std::memcpy(bytes_.data() + offset, &value, sizeof(T));
  }
  template <class T>
  T payloadAt(std::size_t offset) const {
    T value;
    std::memcpy(&value, payload_.data() + offset, sizeof(T));
    return value;
  }
  template <class T>
  void putInPayload(std::size_t offset, T value) {
    std::memcpy(payload_.data() + offset, &value, sizeof(T));
  }
  /// Puts the payload as it is now behind the header.
  void pack() {
    bytes_.resize(kHeader);
    const std::vector<std::uint8_t> frame = compressFrame(payload_, 3);
    bytes_.insert(bytes_.end(), frame.begin(), frame.end());
    seal();
  }
  /// Makes the checksum right, so that what stands behind it is tested.
  void seal() {
    const std::uint64_t before = XXH3_64bits(bytes_.data(), kChecksumAt);
    put(kChecksumAt, std::uint64_t{XXH3_64bits_withSeed(bytes_.data() + kChecksumAt + 8,
                                                        bytes_.size() - kChecksumAt - 8, before)});
  }
  /// Expects that reading the bytes fails with an error that names the file and has `reason` in it.
  void expectRejected(const std::string& reason) {
    writeFileAtomically(file_, std::span<const std::uint8_t>(bytes_));
    try {
      readLdi(file_);
      FAIL() << "was read, but " << reason;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      EXPECT_EQ(std::string(error.what()).rfind(file_ + ": ", 0), 0u) << error.what();
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  Ldi ldi_;
  std::string file_;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint8_t> payload_;  ///< tiles and samples
};

TEST_F(LdiFile, GivesBackWhatWasWritten) {
  const Ldi read = readLdi(file_);
  EXPECT_EQ(read.camera.width, ldi_.camera.width);
  EXPECT_EQ(read.camera.height, ldi_.camera.height);
  EXPECT_EQ(read.camera.center, ldi_.camera.center);
  EXPECT_EQ(read.camera.world_from_pixel, ldi_.camera.world_from_pixel);
  EXPECT_EQ(read.row_tiles, ldi_.row_tiles);
  ASSERT_EQ(read.tiles.size(), ldi_.tiles.size());
  for (std::size_t i = 0; i < read.tiles.size(); ++i) {
    EXPECT_EQ(read.tiles[i].x, ldi_.tiles[i].x);
    EXPECT_EQ(read.tiles[i].y, ldi_.tiles[i].y);
    EXPECT_EQ(read.tiles[i].first, ldi_.tiles[i].first);
    EXPECT_EQ(read.tiles[i].count, ldi_.tiles[i].count);
    EXPECT_EQ(read.tiles[i].greatest_disparity, ldi_.tiles[i].greatest_disparity);
    EXPECT_EQ(read.tiles[i].greatest_footprint, ldi_.tiles[i].greatest_footprint);
  }
  ASSERT_EQ(read.samples.size(), ldi_.samples.size());
  EXPECT_EQ(std::memcmp(read.samples.data(), ldi_.samples.data(), 8 * read.samples.size()), 0);
}

TEST_F(LdiFile, HasTheSameBytesForTheSameLdi) {
  writeLdi(file_, ldi_);
  EXPECT_EQ(readFile(file_), bytes_);
}

TEST_F(LdiFile, KeepsAnEmptyLdi) {
  writeLdi(file_, Ldi{});
  EXPECT_TRUE(readLdi(file_).samples.empty());
}

TEST_F(LdiFile, ItsHeaderAloneTellsWhatItTakesInMemory) {
  const Ldi read = readLdi(file_);
  const auto bytesOf = [](const auto& values) { return values.size() * sizeof(values[0]); };
  EXPECT_EQ(ldiBytesOfFile(file_), bytesOf(read.tiles) + bytesOf(read.row_tiles) +
                                       bytesOf(read.columns) + bytesOf(read.column_first) +
                                       bytesOf(read.column_order) + bytesOf(read.samples));
  bytes_.resize(kHeader);
  writeFileAtomically(file_, std::span<const std::uint8_t>(bytes_));
  EXPECT_EQ(ldiBytesOfFile(file_), ldiBytes(read)) << "nothing else is read";
  bytes_.resize(kHeader - 1);
  writeFileAtomically(file_, std::span<const std::uint8_t>(bytes_));
  EXPECT_THROW(ldiBytesOfFile(file_), Error);
  writeLdi(file_, Ldi{});
  EXPECT_EQ(ldiBytesOfFile(file_), 0u);
}

TEST_F(LdiFile, RejectsAMissingFile) { EXPECT_THROW(readLdi(file_ + ".none"), Error); }

TEST_F(LdiFile, RejectsAnEmptyFile) {
  bytes_.clear();
  expectRejected("is not a layered depth image");
}

TEST_F(LdiFile, RejectsAnotherKindOfFile) {
  bytes_[0] = 'P';
  expectRejected("is not a layered depth image");
}

TEST_F(LdiFile, RejectsATruncatedHeader) {
  bytes_.resize(kHeader - 1);
  expectRejected("is cut short within its header");
}

TEST_F(LdiFile, RejectsAnotherVersion) {
  put(8, std::uint32_t{kLdiFileVersion + 1});
  seal();
  expectRejected(
      "is of format version 3, newer than version 2 that this program reads: use a "
      "newer enfilade");
  put(8, std::uint32_t{kLdiFileVersion - 1});
  seal();
  expectRejected(
      "is of format version 1, older than version 2 that this program reads: preprocess "
      "the model again");
}

TEST_F(LdiFile, RejectsTruncatedSamples) {
  bytes_.resize(bytes_.size() - 8);
  expectRejected("is cut short");
}

TEST_F(LdiFile, RejectsEveryLengthButItsOwn) {
  const std::vector<std::uint8_t> whole = bytes_;
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    bytes_.assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    writeFileAtomically(file_, std::span<const std::uint8_t>(bytes_));
    EXPECT_THROW(readLdi(file_), Error) << length;
  }
  bytes_ = whole;
  bytes_.resize(whole.size() + 8);
  expectRejected("is cut short or damaged");
}

TEST_F(LdiFile, RejectsHugeSizesBeforeItAllocates) {
  put(24, ~std::uint64_t{0});
  put(32, ~std::uint64_t{0});
  seal();
  expectRejected("cannot hold");
  put(24, std::uint64_t{1} << 63);  // the sum of both is 0
  put(32, std::uint64_t{1} << 63);
  seal();
  expectRejected("cannot hold");
  put(24, std::uint64_t{1} << 39);
  put(32, std::uint64_t{1} << 39);
  seal();
  expectRejected("cannot hold");
}

TEST_F(LdiFile, RejectsAPayloadOfAnotherSize) {
  put(32, at<std::uint64_t>(32) + 1);
  seal();
  expectRejected("has a payload of another size than its header says");
}

TEST_F(LdiFile, RejectsAPayloadThatIsDamagedUnderItsChecksum) {
  for (std::size_t offset = kHeader + 16; offset < bytes_.size(); offset += 211) {
    const std::uint8_t was = bytes_[offset];
    bytes_[offset] ^= 0x40;
    seal();
    writeFileAtomically(file_, std::span<const std::uint8_t>(bytes_));
    try {
      readLdi(file_);  // some bytes are but another colour
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    }
    bytes_[offset] = was;
  }
}

TEST_F(LdiFile, RejectsAFlippedBitAnywhere) {
  const std::vector<std::uint8_t> whole = bytes_;
  for (std::size_t offset = 0; offset < whole.size(); offset += 31) {
    bytes_ = whole;
    bytes_[offset] ^= 4;
    writeFileAtomically(file_, std::span<const std::uint8_t>(bytes_));
    EXPECT_THROW(readLdi(file_), Error) << offset;
  }
  bytes_ = whole;
  bytes_.back() ^= 1;
  expectRejected("is cut short or damaged: its checksum does not match");
}

TEST_F(LdiFile, RejectsAHugeWindow) {
  put(16, std::uint32_t{0x7fffffff});
  seal();
  expectRejected("has a window of");
}

TEST_F(LdiFile, RejectsACameraThatSeesNothing) {
  for (std::size_t i = 0; i < 9; ++i) {
    put(72 + 8 * i, 0.0);
  }
  seal();
  expectRejected("has a camera that sees nothing");
  put(48, std::numeric_limits<double>::quiet_NaN());
  seal();
  expectRejected("has a camera that sees nothing");
}

TEST_F(LdiFile, RejectsATileOutsideTheWindow) {
  putInPayload(0, std::uint16_t{60000});
  pack();
  expectRejected("that is out of place");
}

TEST_F(LdiFile, RejectsTilesThatAreNotInOrder) {
  putInPayload(8, payloadAt<std::uint32_t>(0));  // the second tile where the first is
  pack();
  expectRejected("that is out of place");
}

TEST_F(LdiFile, RejectsATileWithoutSamples) {
  putInPayload(4, std::uint32_t{0});
  pack();
  expectRejected("that is out of place");
}

TEST_F(LdiFile, RejectsATileWithMoreSamplesThanThereAre) {
  putInPayload(4, std::uint32_t{0xffffffff});
  pack();
  expectRejected("that is out of place");
}

TEST_F(LdiFile, RejectsSamplesThatBelongToNoTile) {
  put(32, at<std::uint64_t>(32) + 1);
  payload_.resize(payload_.size() + 8);
  pack();
  expectRejected("has samples that belong to no tile");
}

TEST_F(LdiFile, RejectsSamplesThatAreNotInDepthOrder) {
  ASSERT_GT(ldi_.tiles[0].count, 1u);
  putInPayload(8 * ldi_.tiles.size() + 4, std::uint32_t{0xffffffff});
  pack();
  expectRejected("not in depth order");
}

}  // namespace
}  // namespace enfilade
