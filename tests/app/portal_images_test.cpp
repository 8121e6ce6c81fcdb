#include "app/portal_images.h"

#include "scene/error.h"
#include "tests/app/baked_rooms.h"

namespace enfilade {
namespace {

class PortalImagesTest : public testing::BakedRooms {};

TEST_F(PortalImagesTest, AreNotReadByAMachineThatCannotHoldThem) {
  std::uint64_t bytes = 0;
  for (PortalId portal = 0; portal < house_->graph.portals.size(); ++portal) {
    for (const bool front : {true, false}) bytes += baked_->side(portal, front).bytes();
  }
  ASSERT_GT(bytes, 0u);
  const PortalImages none(*house_);
  none.requireMemory(*house_, here_->path(), {}, bytes);
  try {
    none.requireMemory(*house_, here_->path(), {}, bytes - 1);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kMachine);
    EXPECT_TRUE(std::string(error.what()).ends_with(": limit them by --memory")) << error.what();
  }
}

}  // namespace
}  // namespace enfilade
