#include "app/methods.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace enfilade {
namespace {

TEST(Methods, EveryMethodStandsAtItsOwnIndexAndIsFoundByItsName) {
  for (const MethodInfo& info : allMethods()) {
    EXPECT_STREQ(infoOf(info.method).name, info.name);
    EXPECT_EQ(parseMethods(info.name), std::vector<Method>{info.method});
  }
}

TEST(Methods, AListKeepsItsOrder) {
  EXPECT_EQ(parseMethods("ldi,geometry"), (std::vector<Method>{Method::kLdi, Method::kGeometry}));
}

std::string complaintAbout(const std::string& list) {
  try {
    parseMethods(list);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    return error.what();
  }
  ADD_FAILURE() << list << " was taken";
  return {};
}

TEST(Methods, AnUnknownNameIsRefusedWithThoseThereAre) {
  EXPECT_EQ(
      complaintAbout("geometry,magic"),
      "'magic': no such method; there are: geometry, raycast, culling, texture, warp, warp2, ldi");
  EXPECT_NE(complaintAbout("").find("geometry, raycast"), std::string::npos);
  EXPECT_NE(complaintAbout("ldi,,culling").find("no such method"), std::string::npos);
}

TEST(Methods, ANameGivenTwiceIsRefused) {
  EXPECT_EQ(complaintAbout("ldi,ldi"), "'ldi': this method is named twice");
}

TEST(Methods, OnlyTheImagesOfTheMethodsNamedAreNeeded) {
  const auto needed = [](const std::string& list) {
    const std::vector<Method> methods = parseMethods(list);
    return imageKindsOf(methods);
  };
  const ImageKinds none = needed("geometry,raycast,culling");
  EXPECT_FALSE(none.textures || none.references || none.ldis);
  EXPECT_EQ(imageKindNames(needed("geometry,texture")), "texture");
  EXPECT_EQ(imageKindNames(needed("warp2")), "warp");
  EXPECT_EQ(imageKindNames(needed("ldi,warp,culling")), "warp,ldi");
}

}  // namespace
}  // namespace enfilade
