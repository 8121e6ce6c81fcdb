#include "scene/error.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Error, NamesItsSubjectAndReason) {
  const Error error(ErrorKind::kBadInput, "a.glb", "is a picture");
  EXPECT_STREQ(error.what(), "a.glb: is a picture");
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  EXPECT_STREQ(Error(ErrorKind::kMachine, "", "no memory").what(), "no memory");
}

TEST(Error, IsOneLineWhateverTheNamesInAFile) {
  const Error error(ErrorKind::kBadInput, "a\nb.glb", "has no mesh '\x1b[2J\r\x7f'");
  EXPECT_STREQ(error.what(), "a b.glb: has no mesh ' [2J  '");
}

TEST(Error, IsNoLongerThanAPersonCouldRead) {
  const Error error(ErrorKind::kBadInput, "a.glb", std::string(1 << 20, 'x'));
  EXPECT_LT(std::string(error.what()).size(), 8192u);
}

}  // namespace
}  // namespace enfilade
