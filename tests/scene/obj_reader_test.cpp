#include "scene/obj_reader.h"

#include <algorithm>
#include <cmath>

#include "scene/model_reader.h"
#include "scene_test_tools.h"
#include "tests/scene/png_by_hand.h"

namespace enfilade {
namespace {

const std::string kQuad =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

class ObjReader : public testing::Test {
 protected:
  Building read(const std::string& text, const std::string& name = "shed.obj") {
    return readModel(folder_.file(name, text), &warnings_);
  }
  bool warns(const std::string& words) const {
    return std::any_of(warnings_.begin(), warnings_.end(), [&](const std::string& line) {
      return line.find(words) != std::string::npos;
    });
  }

  TempFolder folder_;
  Warnings warnings_;
};

TEST_F(ObjReader, ReadsGroupsAndMaterialsAsObjectsOfNodes) {
  folder_.file("shed.mtl",
               "newmtl wood\nKd 0.5 0.25 0\nnewmtl glass\nKd 1 1 1\nd 0.3\nnewmtl unused\n");
  const Building b = read("# a shed\nmtllib shed.mtl\n" + kQuad +
                          "o wall\nusemtl wood\nf 1/1/1 2/2/1 3/3/1\nusemtl glass\n"
                          "f 1/1/1 3/3/1 4/4/1\no floor\nf -4 -3 -2 -1\n");
  EXPECT_EQ(b.name, "shed");
  ASSERT_EQ(b.nodes.size(), 2u);
  EXPECT_EQ(b.nodes[0].name, "wall");
  EXPECT_EQ(b.nodes[1].name, "floor");
  ASSERT_EQ(b.objects.size(), 3u);
  EXPECT_EQ(triangleCount(b), 4u) << "a polygon becomes triangles";
  EXPECT_EQ(b.materialOf(b.objects[0]).name, "wood");
  EXPECT_NEAR(b.materialOf(b.objects[0]).base_color.r, 0.2140f, 1e-3f) << "Kd is sRGB";
  EXPECT_EQ(b.materialOf(b.objects[1]).alpha_mode, AlphaMode::kBlend);
  EXPECT_NEAR(b.materialOf(b.objects[1]).base_color.a, 0.3f, 1e-6f);
  EXPECT_TRUE(b.materialOf(b.objects[2]).double_sided);
  EXPECT_EQ(worldBounds(b).max, glm::vec3(2, 1, 0));
  EXPECT_TRUE(warnings_.empty()) << warnings_[0];
}

TEST_F(ObjReader, ReadsLinesThatGoOnInTheNext) {
  for (const std::string end : {"\n", "\r\n"}) {
    const Building b = read(kQuad + "f 1 2 \\" + end + " 3 4\nf 1 2 3\n\\");
    EXPECT_EQ(triangleCount(b), 3u);
    const Building thrice = read(kQuad + "f 1 \\" + end + "2 \\" + end + "3\n");
    EXPECT_EQ(triangleCount(thrice), 1u);
    const Building comment = read("# C:\\models\\" + end + kQuad + "f 1 2 3\n");
    EXPECT_EQ(worldBounds(comment).min, glm::vec3(0)) << "the first vertex is no comment";
  }
}

TEST_F(ObjReader, SharesCornersThatAreTheSameAndMakesMissingNormalsFlat) {
  const Building smooth = read(kQuad + "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
  EXPECT_EQ(smooth.vertex_arrays[0].positions.size(), 4u);
  const Building flat = read(kQuad + "f 1 2 3 4\n");
  ASSERT_EQ(flat.vertex_arrays[0].normals.size(), flat.vertex_arrays[0].positions.size());
  for (const glm::vec3& n : flat.vertex_arrays[0].normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST_F(ObjReader, PicturesStandUpright) {
  Image picture;
  picture.width = 1;
  picture.height = 2;
  picture.rgba = {255, 0, 0, 255, 0, 0, 255, 255};
  folder_.file("maps/a b.png", encodePng(picture));
  folder_.file("m.mtl", "newmtl art\nKd 0 0 0\nmap_Kd maps/a b.png\n");
  const Building b = read("mtllib m.mtl\n" + kQuad + "usemtl art\nf 1/1/1 2/2/1 3/3/1\n");
  ASSERT_EQ(b.images.size(), 1u);
  EXPECT_EQ(b.images[0].image.rgba, picture.rgba);
  const Material& art = b.materialOf(b.objects[0]);
  EXPECT_EQ(art.image, 0u);
  EXPECT_EQ(glm::vec3(art.base_color), glm::vec3(1)) << "black under a picture means the picture";
  EXPECT_EQ(b.vertex_arrays[0].texcoords[0], glm::vec2(0, 1)) << "row 0 is on top here";
}

TEST_F(ObjReader, ReadsAPictureOfManyNamesOnce) {
  folder_.file("a.png", encodePng({1, 1, {1, 2, 3, 255}}));
  folder_.file("m.mtl", "newmtl one\nmap_Kd a.png\nnewmtl two\nmap_Kd ./a.png\n");
  const Building b = read("mtllib m.mtl\n" + kQuad + "usemtl one\nf 1 2 3\nusemtl two\nf 1 2 4\n");
  ASSERT_EQ(b.images.size(), 1u);
  for (const Object& object : b.objects) EXPECT_EQ(b.materialOf(object).image, 0u);
}

TEST_F(ObjReader, LeavesOutWhatIsNotThereAndSaysSo) {
  folder_.file("m.mtl", "newmtl art\nmap_Kd gone.png\n");
  const Building b =
      read("mtllib m.mtl\nmtllib gone.mtl\n" + kQuad + "usemtl art\nf 1 2 3\nf 1 2 99\nl 1 2\n");
  EXPECT_EQ(triangleCount(b), 1u);
  EXPECT_TRUE(warns("gone.png"));
  EXPECT_TRUE(warns("gone.mtl"));
  EXPECT_TRUE(warns("corner that is not there"));
  EXPECT_TRUE(warns("lines left out"));
}

TEST_F(ObjReader, ReadsNothingOutsideItsFolderButLooksBesideItself) {
  const std::string text = "mtllib ../m.mtl\nmtllib /home/author/own.mtl\n" + kQuad +
                           "usemtl outside\nf 1 2 3\nusemtl own\nf 1 2 3\n";
  folder_.file("m.mtl", "newmtl outside\nKd 1 0 0\n");
  folder_.file("in/own.mtl", "newmtl own\nKd 0 1 0\nmap_Kd " + (folder_ / "secret.png") + "\n");
  folder_.file("secret.png", encodePng({1, 1, {1, 2, 3, 255}}));
  const Building b = read(text, "in/a.obj");
  EXPECT_TRUE(b.images.empty());
  ASSERT_EQ(b.objects.size(), 2u);
  EXPECT_EQ(b.materialOf(b.objects[0]).name, "own");
  EXPECT_EQ(b.materialOf(b.objects[1]).name, "none");
  EXPECT_TRUE(warns("../m.mtl"));
  EXPECT_TRUE(warns("secret.png"));
}

TEST_F(ObjReader, FollowsNoLinkOutOfItsFolder) {
  folder_.file("m.mtl", "newmtl outside\nKd 1 0 0\n");
  folder_.file("secret.png", encodePng({1, 1, {1, 2, 3, 255}}));
  folder_.file("in/own.mtl", "newmtl own\nmap_Kd link.png\nnewmtl up\nmap_Kd up/secret.png\n");
  std::filesystem::create_symlink("../m.mtl", folder_ / "in/link.mtl");
  std::filesystem::create_symlink("../secret.png", folder_ / "in/link.png");
  std::filesystem::create_directory_symlink("..", folder_ / "in/up");
  const Building b = read("mtllib link.mtl\nmtllib up/m.mtl\nmtllib own.mtl\n" + kQuad +
                              "usemtl outside\nf 1 2 3\nusemtl own\nf 1 2 3\n",
                          "in/a.obj");
  EXPECT_TRUE(b.images.empty());
  EXPECT_EQ(b.materialOf(b.objects[0]).name, "own");
  EXPECT_EQ(b.materialOf(b.objects[1]).name, "none");
  EXPECT_TRUE(warns("link.mtl"));
  EXPECT_TRUE(warns("link.png"));
}

TEST_F(ObjReader, FindsLibrariesWithBlanksWithBackslashesAndSeveralInALine) {
  folder_.file("my shed.mtl", "newmtl one\nKd 1 0 0\n");
  folder_.file("own.mtl", "newmtl two\nKd 1 0 0\n");
  folder_.file("more.mtl", "newmtl three\nKd 1 0 0\n");
  const Building b = read(
      "\xef\xbb\xbfmtllib my shed.mtl\nmtllib C:\\work\\own.mtl\r\n"
      "mtllib gone.mtl more.mtl\n" +
      kQuad + "usemtl one\nf 1 2 3\nusemtl two\nf 1 2 3\nusemtl three\nf 1 2 3\n");
  ASSERT_EQ(b.objects.size(), 3u);
  EXPECT_EQ(b.materialOf(b.objects[0]).name, "one");
  EXPECT_EQ(b.materialOf(b.objects[1]).name, "two");
  EXPECT_EQ(b.materialOf(b.objects[2]).name, "three");
  EXPECT_TRUE(warns("gone.mtl"));
  EXPECT_EQ(warnings_.size(), 1u) << warnings_[0];
}

TEST_F(ObjReader, KeepsADoorwayInAWallsOutlineOpen) {
  const Building b = read(
      "v -12 -12 0\nv -10 -12 0\nv -10 -10 0\nv -9 -10 0\nv -9 -12 0\n"
      "v -7 -12 0\nv -7 -9 0\nv -12 -9 0\nf 1 2 3 4 5 6 7 8\n");
  float area = 0;
  const auto& p = b.vertex_arrays[0].positions;
  const auto& indices = b.meshes[0].indices;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    area += 0.5f * glm::length(glm::cross(p[indices[i + 1]] - p[indices[i]],
                                          p[indices[i + 2]] - p[indices[i]]));
  }
  EXPECT_FLOAT_EQ(area, 13);
}

/// A circle of so many corners as one face, and a triangle.
std::string circle(int corners) {
  std::string text, face = "f";
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  return text + face + "\nv 5 5 5\nv 6 5 5\nv 6 6 5\nf -3 -2 -1\n";
}

TEST_F(ObjReader, TakesFacesOfHundredsOfCorners) {
  EXPECT_EQ(triangleCount(read(circle(400))), 399u);
}

TEST_F(ObjReader, LeavesOutFacesOfThousandsOfCorners) {
  EXPECT_EQ(triangleCount(read(circle(3000))), 1u);
  EXPECT_TRUE(warns("faces of over 2048 corners left out: 3000 corners"));
}

TEST_F(ObjReader, TakesLinesThatEndAsOnOldMacintoshes) {
  std::string text = circle(300);
  const std::size_t triangles = triangleCount(read(text));
  EXPECT_EQ(triangles, 299u);
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(triangleCount(read(text)), triangles);
}

TEST_F(ObjReader, ReadsALibraryThatIsNamedAgainOnce) {
  folder_.file("paint.mtl", "newmtl red\nKd 1 0 0\n");
  std::string text;
  for (int i = 0; i < 5; ++i) text += "mtllib paint.mtl\n";
  const Building b = read(text + kQuad + "usemtl red\nf 1 2 3 4\n");
  EXPECT_EQ(b.materials.size(), 2u);  // and that of faces without
}

TEST_F(ObjReader, AColourThatIsNoNumberIsBlack) {
  const Building b = read("v 0 0 0 0e999 1 1\nv 1 0 0 1 1 1\nv 1 1 0 1 1 1\nf 1 2 3\n");
  ASSERT_EQ(b.vertex_arrays[0].colors.size(), 3u);
  EXPECT_EQ(b.vertex_arrays[0].colors[0].r, 0);
  EXPECT_EQ(b.vertex_arrays[0].colors[1].r, 65535);
}

TEST_F(ObjReader, CutsLongNames) {
  const Building b = read(kQuad + "o " + std::string(5000, 'x') + "\nf 1 2 3 4\n");
  EXPECT_EQ(b.nodes.at(0).name, std::string(1000, 'x'));
}

/// A PNG of 8192 × 8192 pixels of a bit each, all black but for some of the first.
std::vector<std::uint8_t> largePng(std::uint8_t first) {
  std::vector<std::uint8_t> rows(std::size_t{8192} * (1 + 8192 / 8), 0);
  rows[1] = first;
  return pngByHand(8192, 1, 0, rows);
}

TEST_F(ObjReader, LeavesOutPicturesOfFarMorePixelsThanBytes) {
  std::string library, text = "mtllib l.mtl\n" + kQuad;
  for (int i = 0; i < 3; ++i) {
    const std::string name = std::to_string(i);
    folder_.file(name + ".png", largePng(static_cast<std::uint8_t>(i)));
    library += "newmtl m" + name + "\nmap_Kd " + name + ".png\n";
    text += "usemtl m" + name + "\nf 1/1 2/2 3/3 4/4\n";
  }
  folder_.file("l.mtl", library);
  const Building b = read(text);
  EXPECT_EQ(b.images.size(), 1u);
  EXPECT_TRUE(warns("of far more pixels than their bytes can hold"));
}

TEST_F(ObjReader, RefusesWhatHoldsNoTriangles) {
  const std::string empty = folder_.file("empty.obj", kQuad + "f 7 8 9\n");
  expectError([&] { readModel(empty); }, ErrorKind::kBadInput, empty,
              "holds no triangles: noticed: Vertex indices out of bounds");
  const std::string flat =
      folder_.file("flat.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3 4\n");
  expectError([&] { readModel(flat); }, ErrorKind::kBadInput, flat,
              "holds no triangles: faces without area");
  const std::string far =
      folder_.file("far.obj", "v 1e13 0 0\nv 2e13 0 0\nv 1e13 1e13 0\nf 1 2 3\n");
  expectError([&] { readModel(far); }, ErrorKind::kBadInput, far, "no number within 1e12 m");
  const std::string other = folder_.file("other.obj", "solid cube\nfacet normal 0 0 1\n");
  expectError([&] { readObj(other); }, ErrorKind::kBadInput, other, "seems to be an STL file");
  EXPECT_FALSE(looksLikeObj({}));
  const std::string curves = "# points first\nvp 0.5\n";
  EXPECT_TRUE(looksLikeObj({reinterpret_cast<const std::uint8_t*>(curves.data()), curves.size()}));
}

TEST_F(ObjReader, PassesOverCornersThatAreNoNumbers) {
  const Building b =
      read("v 1e999 0 0\nv 1 -1e999 1\nv 3e38 0 0\n" + kQuad + "f 1 4 5\nf 4 5 6\nf 3 4 5\n");
  EXPECT_EQ(triangleCount(b), 1u);
  const Box box = worldBounds(b);
  EXPECT_TRUE(std::isfinite(box.min.x) && std::isfinite(box.max.x));
}

}  // namespace
}  // namespace enfilade
