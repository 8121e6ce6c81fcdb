#include <gtest/gtest.h>

#include "gltf_builder.h"
#include "scene/gltf_reader.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A triangle with a picture; whence its buffer and its picture come is up to the test.
class GltfFiles : public testing::Test {
 protected:
  GltfFiles() {
    const int positions = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", kF32);
    builder_.add("textures", {{"source", 0}});
    builder_.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder_.add(
        "nodes",
        {{"mesh", builder_.mesh({{"attributes", {{"POSITION", positions}}}, {"material", 0}})}});
    builder_.root["images"] = {{{"uri", "data:image/png;base64," + GltfBuilder::base64(png_)}}};
  }
  void bufferFrom(const std::string& uri) {
    builder_.root["buffers"] = {{{"uri", uri}, {"byteLength", builder_.bin.size()}}};
  }
  void pictureFrom(const std::string& uri) { builder_.root["images"] = {{{"uri", uri}}}; }
  std::string gltf() { return folder_.file("models/house.gltf", builder_.gltf()); }
  void expectWhole(const Building& building) {
    EXPECT_EQ(triangleCount(building), 1u);
    ASSERT_EQ(building.images.size(), 1u) << (warnings_.empty() ? "" : warnings_[0]);
    EXPECT_EQ(building.images[0].encoded, png_);
  }
  void expectBad(const std::string& words) {
    const std::string file = gltf();
    expectError([&] { readGltf(file); }, ErrorKind::kBadInput, file, words);
  }

  const std::vector<std::uint8_t> png_ = encodePng({1, 1, {1, 2, 3, 255}});
  GltfBuilder builder_;
  TempFolder folder_;
  Warnings warnings_;
};

TEST_F(GltfFiles, MayBeEmbeddedAsDataUris) { expectWhole(readGltf(gltf(), &warnings_)); }

TEST_F(GltfFiles, MayStandBesideTheModelUnderPercentEncodedNames) {
  folder_.file("models/the buffer+1.bin", builder_.bin);
  folder_.file("models/pictures/größe.png", png_);
  bufferFrom("the%20buffer+1.bin");
  pictureFrom("./pictures/gr%C3%B6%c3%9fe.png");
  expectWhole(readGltf(gltf(), &warnings_));
}

TEST_F(GltfFiles, AreFoundBehindBackslashes) {
  folder_.file("models/pictures/a.png", png_);
  pictureFrom("pictures\\a.png");
  expectWhole(readGltf(gltf(), &warnings_));
}

TEST_F(GltfFiles, AreFoundWhateverTheWorkingFolderIs) {
  folder_.file("models/b.bin", builder_.bin);
  bufferFrom("b.bin");
  gltf();
  const fs::path before = fs::current_path();
  fs::current_path(folder_ / "models");
  EXPECT_NO_THROW(readGltf("house.gltf"));
  fs::current_path(before);
}

TEST_F(GltfFiles, OfAGlbMayBeExternalToo) {
  folder_.file("a.png", png_);
  pictureFrom("a.png");
  expectWhole(readGltf(folder_.file("house.glb", builder_.glb()), &warnings_));
}

TEST_F(GltfFiles, MayBeLongerThanTheBuffer) {
  std::vector<std::uint8_t> longer = builder_.bin;
  longer.resize(longer.size() + 100);
  folder_.file("models/b.bin", longer);
  bufferFrom("b.bin");
  expectWhole(readGltf(gltf(), &warnings_));
}

TEST_F(GltfFiles, AreRejectedOutsideTheModelsFolder) {
  folder_.file("secret.bin", builder_.bin);
  folder_.file("secret.png", png_);
  for (const std::string uri : {"../secret.bin", "%2e%2e/secret.bin", "x/../../secret.bin",
                                "..%2Fsecret.bin", "..\\secret.bin", "../models-not/secret.bin"}) {
    bufferFrom(uri);
    expectBad("lies outside the model's own folder");
  }
  bufferFrom(folder_ / "secret.bin");
  expectBad("lies outside the model's own folder");
  builder_.root.erase("buffers");
  pictureFrom("../secret.png");
  expectBad("lies outside the model's own folder");
}

TEST_F(GltfFiles, AreRejectedWhereASymbolicLinkLeadsOutside) {
  folder_.file("secret.bin", builder_.bin);
  fs::create_directories(folder_ / "models");
  fs::create_symlink("../secret.bin", folder_ / "models/link.bin");
  fs::create_directory_symlink("..", folder_ / "models/up");
  bufferFrom("link.bin");
  expectBad("lies outside the model's own folder");
  bufferFrom("up/secret.bin");
  expectBad("lies outside the model's own folder");
}

TEST_F(GltfFiles, MayLieBehindALinkThatStaysInside) {
  folder_.file("models/data/b.bin", builder_.bin);
  fs::create_symlink("data/b.bin", folder_ / "models/link.bin");
  bufferFrom("link.bin");
  expectWhole(readGltf(gltf(), &warnings_));
}

TEST_F(GltfFiles, AreNotFetchedFromTheNet) {
  bufferFrom("https://example.org/b.bin");
  expectBad("is an address");
  bufferFrom("file:///etc/passwd");
  expectBad("is an address");
}

TEST_F(GltfFiles, MayNotBeNamedWithoutEnd) {
  folder_.file("models/big.bin", std::string(std::size_t{8} << 20, '\0'));
  builder_.root["buffers"] =
      std::vector<Json>(20, Json{{"uri", "big.bin"}, {"byteLength", builder_.bin.size()}});
  expectBad("names the same files again and again");
}

TEST_F(GltfFiles, NameABufferThatIsMissingOrTooShort) {
  bufferFrom("none.bin");
  const std::string file = gltf();
  expectError([&] { readGltf(file); }, ErrorKind::kBadInput,
              fs::canonical(folder_ / "models") / "none.bin", "no such file");
  folder_.file("models/short.bin", "abc");
  bufferFrom("short.bin");
  expectBad("buffer 0 has 3 of its 36 bytes");
}

TEST_F(GltfFiles, RejectADamagedDataUri) {
  bufferFrom("data:application/octet-stream;base64,AAAA*AAA");
  expectBad("not valid base64");
  bufferFrom("data:");
  expectBad("data URI is damaged");
}

TEST_F(GltfFiles, GoWithoutAPictureThatIsMissing) {
  pictureFrom("none.png");
  EXPECT_EQ(readGltf(gltf(), &warnings_).materials[0].image, kNone);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(warnings_[0].starts_with("picture left out: ")) << warnings_[0];
  EXPECT_NE(warnings_[0].find("none.png: no such file"), std::string::npos) << warnings_[0];
}

}  // namespace
}  // namespace enfilade
