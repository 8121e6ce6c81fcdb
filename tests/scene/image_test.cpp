#include "scene/image.h"

#include <gtest/gtest.h>
#include <stb/stb_image_write.h>

#include <algorithm>

#include "scene/file_io.h"
#include "scene_test_tools.h"
#include "tests/scene/png_by_hand.h"

namespace enfilade {
namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int v : {x * 7, y * 5, x ^ y, 255 - x * y}) {
        image.rgba.push_back(static_cast<std::uint8_t>(v));
      }
    }
  }
  return image;
}

/// A 1 × 2 grey PNG, its top row white, its bottom row black; made by hand, not by our encoder.
const std::vector<std::uint8_t> kWhiteOverBlack{
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
    0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x08, 0x00, 0x00, 0x00,
    0x00, 0xbc, 0xea, 0xe9, 0xfb, 0x00, 0x00, 0x00, 0x0c, 0x49, 0x44, 0x41, 0x54, 0x78,
    0x9c, 0x63, 0xf8, 0xcf, 0xc0, 0x00, 0x00, 0x03, 0x01, 0x01, 0x00, 0xc9, 0xfe, 0x92,
    0xef, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

TEST(Image, SurvivesPngWithEveryPixelAndItsAlpha) {
  const Image image = gradient(37, 21);
  const Image back = decodeImage(encodePng(image), "test");
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 21);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(Image, EncodesToTheSameBytesEveryTime) {
  EXPECT_EQ(encodePng(gradient(64, 48)), encodePng(gradient(64, 48)));
}

TEST(Image, HasItsTopRowFirst) {
  const Image image = decodeImage(kWhiteOverBlack, "test");
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 255}));
}

TEST(Image, IsWrittenToAndReadFromAFile) {
  const TempFolder folder;
  writePng(folder / "a.png", gradient(5, 4));
  EXPECT_EQ(readImage(folder / "a.png").rgba, gradient(5, 4).rgba);
}

TEST(Image, ItsSizeIsReadFromAFileWithoutItsPixels) {
  const TempFolder folder;
  std::vector<std::uint8_t> png = encodePng(gradient(70, 40));
  png.resize(png.size() / 2);
  writeFileAtomically(folder / "half.png", std::span<const std::uint8_t>(png));
  EXPECT_EQ(readImageSize(folder / "half.png"), glm::ivec2(70, 40));
  expectError([&] { readImageSize(folder / "none.png"); }, ErrorKind::kBadInput,
              folder / "none.png", "no such file");
  folder.file("a.gif", "GIF89a, or so");
  expectError([&] { readImageSize(folder / "a.gif"); }, ErrorKind::kBadInput, folder / "a.gif",
              "is neither a PNG nor a JPEG");
  png.resize(20);
  writeFileAtomically(folder / "cut.png", std::span<const std::uint8_t>(png));
  expectError([&] { readImageSize(folder / "cut.png"); }, ErrorKind::kBadInput, folder / "cut.png",
              "cannot be decoded");
}

TEST(Image, ReadsJpeg) {
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < 16 * 16; ++i) {
    for (const int v : {200, 100, 50}) rgb.push_back(static_cast<std::uint8_t>(v));
  }
  std::vector<std::uint8_t> jpeg;
  const auto append = [](void* out, void* data, int size) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(out)->insert(
        static_cast<std::vector<std::uint8_t>*>(out)->end(), begin, begin + size);
  };
  ASSERT_TRUE(stbi_write_jpg_to_func(append, &jpeg, 16, 16, 3, rgb.data(), 95));
  EXPECT_EQ(imageMimeType(jpeg), "image/jpeg");
  const Image image = decodeImage(jpeg, "test");
  EXPECT_EQ(image.width, 16);
  EXPECT_NEAR(image.rgba[0], 200, 4);
  EXPECT_NEAR(image.rgba[1], 100, 4);
  EXPECT_NEAR(image.rgba[2], 50, 4);
  EXPECT_EQ(image.rgba[3], 255);
}

TEST(Image, RejectsWhatIsNeitherPngNorJpeg) {
  const std::string gif = "GIF89a\x01\0\x01\0";
  expectError(
      [&] {
        decodeImage({gif.begin(), gif.end()}, "a.gif");
      },
      ErrorKind::kBadInput, "a.gif", "is neither a PNG nor a JPEG");
  expectError([] { decodeImage({}, "empty"); }, ErrorKind::kBadInput, "empty", "neither");
}

TEST(Image, RejectsATruncatedPng) {
  std::vector<std::uint8_t> png = encodePng(gradient(64, 64));
  png.resize(png.size() / 2);
  expectError([&] { decodeImage(png, "cut.png"); }, ErrorKind::kBadInput, "cut.png",
              "cannot be decoded");
}

TEST(Image, RejectsAPngThatSaysItIsHuge) {
  std::vector<std::uint8_t> png = encodePng(gradient(4, 4));
  png[16] = 0x00;  // the width, big-endian
  png[17] = 0x01;
  expectError([&] { decodeImage(png, "huge.png"); }, ErrorKind::kBadInput, "huge.png",
              "at most 8192 x 8192");
}

TEST(Image, RejectsAPngOfAGigabyteInAFewBytes) {
  std::vector<std::uint8_t> png = encodePng(gradient(4, 4));
  for (const std::size_t at : {18U, 22U}) {  // both sides are 8192
    png[at] = 0x20;
    png[at + 1] = 0;
  }
  expectError([&] { decodeImage(png, "bomb.png"); }, ErrorKind::kBadInput, "bomb.png",
              "says that it is 8192 x 8192 pixels, more than its bytes can hold");
}

TEST(Image, RejectsAJpegOfAGigabyteInAFewBytes) {
  std::vector<std::uint8_t> jpeg = encodeJpeg(gradient(8, 8), 90);
  const std::vector<std::uint8_t> frame{0xff, 0xc0};
  const auto sizes = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end()) + 5;
  std::copy_n(std::vector<std::uint8_t>{0x20, 0, 0x20, 0}.begin(), 4, sizes);
  expectError([&] { decodeImage(jpeg, "bomb.jpg"); }, ErrorKind::kBadInput, "bomb.jpg",
              "says that it is 8192 x 8192 pixels, more than its bytes can hold");
}

TEST(Image, RejectsAPngWhoseChunkIsLongerThanTheFile) {
  std::vector<std::uint8_t> png = encodePng(gradient(4, 4));
  png[33] = 0x49;  // of IDAT's length
  expectError([&] { decodeImage(png, "chunk.png"); }, ErrorKind::kBadInput, "chunk.png",
              "it is cut short, or damaged");
}

/// A PNG of 1 × 1 pixels whose data come to `size` zeros.
std::vector<std::uint8_t> pngOfZeros(std::size_t size) {
  return pngByHand(1, 8, 6, std::vector<std::uint8_t>(size, 0));
}

TEST(Image, RejectsAPngOfOnePixelAndMuchData) {
  EXPECT_EQ(decodeImage(pngOfZeros(100), "small.png").width, 1);
  expectError([&] { decodeImage(pngOfZeros(std::size_t{400} << 20), "bomb.png"); },
              ErrorKind::kBadInput, "bomb.png", "far more data than its pixels need");
}

TEST(Image, RejectsAJpegOfTooManyScans) {
  std::vector<std::uint8_t> jpeg = encodeJpeg(gradient(512, 512), 90);
  EXPECT_EQ(decodeImage(jpeg, "few.jpg").width, 512);
  const std::vector<std::uint8_t> start{0xff, 0xda};
  const auto scan = std::search(jpeg.begin(), jpeg.end(), start.begin(), start.end());
  const std::vector<std::uint8_t> head(scan, scan + 14);
  for (int i = 0; i < 9000; ++i) jpeg.insert(jpeg.end() - 2, head.begin(), head.end());
  expectError([&] { decodeImage(jpeg, "many.jpg"); }, ErrorKind::kBadInput, "many.jpg",
              "has 9001 scans");
}

TEST(Image, TakesAPictureOfOneColourThatPacksWell) {
  const Image grey{2048, 1024, std::vector<std::uint8_t>(std::size_t{4} * 2048 * 1024, 128)};
  EXPECT_EQ(decodeImage(encodePng(grey), "grey.png").rgba, grey.rgba);
  EXPECT_EQ(decodeImage(encodeJpeg(grey, 1), "grey.jpg").width, 2048);
}

TEST(Image, NamesAFileThatIsMissing) {
  expectError([] { readImage("/no/such.png"); }, ErrorKind::kBadInput, "/no/such.png",
              "no such file");
}

}  // namespace
}  // namespace enfilade
