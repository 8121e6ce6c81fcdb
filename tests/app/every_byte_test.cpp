// Every byte of a house: each file cut at every length, and every byte flipped, one at a time.
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "app/frame_painter.h"
#include "app/portal_images.h"
#include "preprocess/bake_images.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// All bytes by hand, ENFILADE_EVERY_BYTE=1; in the suite one in so many.
std::size_t stride() { return std::getenv("ENFILADE_EVERY_BYTE") != nullptr ? 1 : 13; }

class EveryByte : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    here_ = std::make_unique<TemporaryFolder>();
    ImageParameters parameters = parametersForAllImages();
    parameters.image_size = 16;
    parameters.rings = {{2, 40.0f, 0.0f}};
    parameters.textures = parameters.references = 2;
    House house = colouredTwoRooms();
    house.info.parameters = imageParameterTexts(parameters);
    bakeImages(house, parameters, here_->path(), {GlBackend::kOsMesa, 1}, {});
    fs::remove_all(*here_ / "sides");  // the records of a house that is not yet finished
    writeHouse(here_->path(), house);
    gl_ = createOsMesaContext(1);
    pictures_ = pictures();
  }
  static void TearDownTestSuite() {
    gl_.reset();
    here_.reset();
  }

  /// What a viewer before the doorway sees of the house in the folder by each method.
  static std::vector<Image> pictures() {
    House house = readHouse(here_->path());
    const PortalImages images(house, here_->path());
    FramePainter painter(*gl_, house, images, 80, 64, 1);
    Camera camera = walkingCamera(house, 1.2f, 80, 64);
    camera.pose = lookAt(glm::vec3(1.5f, 1.6f, 1.4f), glm::vec3(4.1f, 1.2f, 2.0f));
    std::vector<Image> seen;
    for (const Method method : {Method::kGeometry, Method::kCulling, Method::kTexture,
                                Method::kWarp, Method::kWarp2, Method::kLdi}) {
      painter.paint(method, camera);
      painter.read(seen.emplace_back());
    }
    return seen;
  }

  /// Whether the house in the folder is refused by an error that names `file`, or shows what it
  /// did.  Anything else fails, with `what` was done to the file.
  static bool refused(const std::string& file, const std::string& what) {
    try {
      const House house = readHouse(here_->path());
      const PortalImages images(house, here_->path());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << what;
      EXPECT_TRUE(std::string(error.what()).starts_with(file)) << what << ": " << error.what();
      return true;
    }
    const std::vector<Image> seen = pictures();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(seen[i].rgba, pictures_[i].rgba) << file << what << ", method " << i;
    }
    return false;
  }

  static void write(const std::string& file, std::span<const std::uint8_t> bytes) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  }

  static std::vector<std::string> files() {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(here_->path())) {
      if (entry.is_regular_file()) files.push_back(entry.path().string());
    }
    return files;
  }

  static std::unique_ptr<TemporaryFolder> here_;
  static std::unique_ptr<GlContext> gl_;
  static std::vector<Image> pictures_;
};
std::unique_ptr<TemporaryFolder> EveryByte::here_;
std::unique_ptr<GlContext> EveryByte::gl_;
std::vector<Image> EveryByte::pictures_;

TEST_F(EveryByte, TheHouseShowsItsImages) {
  ASSERT_EQ(files().size(), 3u + 2 * (1 + 2 + 2));
  for (std::size_t method = 2; method < pictures_.size(); ++method) {
    EXPECT_NE(pictures_[method].rgba, pictures_[0].rgba) << "no image is seen by method " << method;
  }
}

TEST_F(EveryByte, FlippedIsToldOrShowsTheSame) {
  std::size_t flipped = 0, told = 0;
  for (const std::string& file : files()) {
    std::vector<std::uint8_t> bytes = readFile(file);
    for (std::size_t at = flipped % stride(); at < bytes.size(); at += stride()) {
      const auto good = bytes[at];
      bytes[at] = static_cast<std::uint8_t>(good ^ (1u << (at % 8)));
      write(file, bytes);
      told += refused(file, " with byte " + std::to_string(at) + " flipped");
      bytes[at] = good;
      ++flipped;
      if (HasFailure()) return write(file, bytes);
    }
    write(file, bytes);
  }
  std::printf("%zu bytes flipped: %zu told\n", flipped, told);
  EXPECT_EQ(told, flipped);
}

TEST_F(EveryByte, CutShortIsToldAtEveryLength) {
  std::size_t cut = 0, told = 0;
  for (const std::string& file : files()) {
    const std::vector<std::uint8_t> bytes = readFile(file);
    for (std::size_t size = 0; size < bytes.size();
         size += size + stride() < bytes.size() ? stride() : 1) {
      write(file, std::span(bytes).first(size));
      told += refused(file, " cut to " + std::to_string(size) + " bytes");
      ++cut;
      if (HasFailure()) return write(file, bytes);
    }
    write(file, bytes);
  }
  std::printf("%zu cuts: %zu told\n", cut, told);
  EXPECT_EQ(told, cut);
}

TEST_F(EveryByte, AFileThatGrewIsMissingOrIsAnothersIsTold) {
  for (const std::string& file : files()) {
    std::vector<std::uint8_t> bytes = readFile(file);
    bytes.push_back(bytes.back());
    write(file, bytes);
    EXPECT_TRUE(refused(file, " with a byte more"));
    bytes.pop_back();
    fs::remove(file);
    const std::string house_json = houseJsonFile(here_->path());
    EXPECT_TRUE(refused(file == house_json ? here_->path() : file, " removed"));
    write(file, bytes);
  }
  const std::string front = portalImageFolder(here_->path(), 0, true) + "/";
  const std::string back = portalImageFolder(here_->path(), 0, false) + "/";
  for (const char* image : {"ldi.bin", "texture-01.png", "reference-00.bin"}) {
    const std::vector<std::uint8_t> bytes = readFile(front + image);
    write(front + image, readFile(back + image));
    EXPECT_TRUE(refused(front + image, " taken from the other side"));
    write(front + image, bytes);
  }
  EXPECT_EQ(pictures().size(), pictures_.size());
}

}  // namespace
}  // namespace enfilade
