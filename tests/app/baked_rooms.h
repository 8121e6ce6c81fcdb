#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "app/portal_images.h"
#include "preprocess/bake_images.h"
#include "render/gl_context.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade::testing {

/// colouredTwoRooms() with images of every kind, baked once for all tests of a suite.
class BakedRooms : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    here_ = std::make_unique<TemporaryFolder>();
    house_ = std::make_unique<House>(colouredTwoRooms());
    bakeImages(*house_, parametersForAllImages(), here_->path(), {GlBackend::kOsMesa, 1}, {});
    baked_ = std::make_unique<PortalImages>(*house_, here_->path());
    gl_ = createOsMesaContext(1);
  }
  static void TearDownTestSuite() {
    gl_.reset();
    baked_.reset();
    house_.reset();
    here_.reset();
  }

  static inline std::unique_ptr<TemporaryFolder> here_;
  static inline std::unique_ptr<House> house_;
  static inline std::unique_ptr<PortalImages> baked_;
  static inline std::unique_ptr<GlContext> gl_;
};

}  // namespace enfilade::testing
