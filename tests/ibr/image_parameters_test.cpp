#include "ibr/image_parameters.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace enfilade {
namespace {

TEST(ImageParameters, AreReadAsTheSameNumbersThatWereRecorded) {
  ImageParameters parameters;
  parameters.image_size = 384;
  parameters.rings = {{7, 71.3f, 0.0f}, {4, 0.1f + 0.2f, 0.25f}, {6, 62.5f, -1.0f / 3.0f}};
  parameters.ldi = LdiMaking::kRayCast;
  parameters.rays = 3;
  parameters.textures = 180;
  parameters.references = 1;
  parameters.switch_distance = 2.2f;
  parameters.portal_margin = 0.0f;
  parameters.ldi_half_width = 7.77f;
  parameters.depth_threshold = 1.0f / 7.0f;
  const auto texts = imageParameterTexts(parameters);
  const ImageParameters again = imageParametersFrom(texts, "house.json");
  EXPECT_EQ(imageParameterTexts(again).size(), texts.size());
  EXPECT_EQ(again.image_size, parameters.image_size);
  EXPECT_EQ(again.ldi, parameters.ldi);
  EXPECT_EQ(again.rays, parameters.rays);
  EXPECT_EQ(again.textures, parameters.textures);
  EXPECT_EQ(again.references, parameters.references);
  EXPECT_EQ(again.switch_distance, parameters.switch_distance);
  EXPECT_EQ(again.portal_margin, parameters.portal_margin);
  EXPECT_EQ(again.ldi_half_width, parameters.ldi_half_width);
  EXPECT_EQ(again.depth_threshold, parameters.depth_threshold);
  ASSERT_EQ(again.rings.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.rings[i].captures, parameters.rings[i].captures);
    EXPECT_EQ(again.rings[i].angle, parameters.rings[i].angle);
    EXPECT_EQ(again.rings[i].above_eye, parameters.rings[i].above_eye);
  }
}

TEST(ImageParameters, AHouseThatRecordsNoneHasTheDefaults) {
  const auto texts = imageParameterTexts(imageParametersFrom({{"voxel_m", "0.1"}}, "house.json"));
  EXPECT_EQ(texts, imageParameterTexts(ImageParameters()));
}

TEST(ImageParameters, ANumberOfCapturesIsOneRingOfThem) {
  const ImageParameters read = imageParametersFrom({{"captures", "11"}}, "house.json");
  ASSERT_EQ(read.rings.size(), 1u);
  EXPECT_EQ(read.rings[0].captures, 11);
}

TEST(ImageParameters, RejectsWhatCannotBe) {
  const std::pair<const char*, const char*> bad[] = {
      {"image_size_px", "1000000"}, {"image_size_px", "many"},   {"captures", "0"},
      {"textures_per_portal", ""},  {"images_per_portal", "6 "}, {"switch_distance_m", "nan"},
      {"captures", "ring"},         {"captures", "ring:6@-0.5,"}};
  for (const auto& [name, text] : bad) {
    try {
      imageParametersFrom({{name, text}}, "house.json");
      ADD_FAILURE() << name << " = " << text << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      EXPECT_EQ(std::string(error.what()), "house.json: its parameter " + std::string(name) +
                                               " is '" + text + "', which cannot be");
    }
  }
}

TEST(ImageKinds, AListIsReadAsItIsWritten) {
  for (const char* list : {"texture", "warp,ldi", "texture,warp,ldi"}) {
    EXPECT_EQ(imageKindNames(parseImageKinds(list)), list);
  }
  EXPECT_EQ(imageKindNames(parseImageKinds("ldi,texture")), "texture,ldi");
  for (const char* list : {"", "impostor", "ldi,", ",ldi", "ldi texture"}) {
    EXPECT_THROW(parseImageKinds(list), Error) << list;
  }
}

}  // namespace
}  // namespace enfilade
