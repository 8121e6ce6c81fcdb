// Walks with a limit on the memory for images, on a house of two rooms in many colours.
#include "app/limited_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <semaphore>

#include "app/frame_painter.h"
#include "app/walk.h"
#include "preprocess/tour.h"
#include "scene/error.h"
#include "tests/app/baked_rooms.h"

namespace enfilade {
namespace {

using Pace = LimitedImages::Pace;
using Frames = std::vector<std::vector<std::uint8_t>>;  // their pixels

constexpr int kWidth = 96;
constexpr int kHeight = 80;
constexpr std::size_t kPlenty = std::size_t{1} << 30;
const Method kImageMethods[] = {Method::kTexture, Method::kWarp, Method::kWarp2, Method::kLdi};

class LimitedImagesTest : public testing::BakedRooms {
 protected:
  static void SetUpTestSuite() {
    BakedRooms::SetUpTestSuite();
    path_ = makeTour(*house_, {.frames = 40}).path;
  }

  static Walk walk() { return {path_, walkingCamera(*house_, 1.2f, kWidth, kHeight)}; }

  /// The frame of that number, and what it cost.
  static std::pair<std::vector<std::uint8_t>, FrameCost> frame(FramePainter& painter, Method method,
                                                               std::size_t number) {
    const FrameCost cost = painter.paint(method, walk().stepTo(number, painter));
    Image picture;
    painter.read(picture);
    return {picture.rgba, cost};
  }

  static Frames framesOf(FramePainter& painter, Method method) {
    painter.prepare(method);
    Frames frames;
    for (std::size_t i = 0; i < walk().frames(); ++i) {
      frames.push_back(frame(painter, method, i).first);
    }
    return frames;
  }

  /// The frames of the walk by a method, with all images there.
  static Frames unlimited(Method method) {
    FramePainter painter(*gl_, *house_, *baked_, kWidth, kHeight, 1);
    return framesOf(painter, method);
  }

  /// The same under a limit.
  static Frames limited(Method method, std::size_t most, int threads = 1,
                        const ImageStore::Read& read = readSideImages) {
    LimitedImages images(*house_, here_->path(), most, Pace::kByFrames, read);
    FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, threads);
    painter.setLimited(&images);
    return framesOf(painter, method);
  }

  static std::size_t bytesOf(ImageKind kind, bool from_front) {
    return lookAtSideImages({*house_, here_->path(), 0, from_front}, kind,
                            std::as_const(*baked_).side(0, from_front))
        .bytes;
  }
  /// Enough for one of the two sides.
  static std::size_t oneSide(ImageKind kind) {
    return std::max(bytesOf(kind, true), bytesOf(kind, false));
  }

  static inline CameraPath path_;
};

TEST_F(LimitedImagesTest, TheFilesHeadersTellWhatImagesTakeInMemory) {
  for (const ImageKind kind : kAllImageKinds) {
    for (const bool from_front : {true, false}) {
      SideImages only = PortalImages(*house_).side(0, from_front);
      readSideImages({*house_, here_->path(), 0, from_front}, kind, only);
      EXPECT_GT(only.bytes(), 1000u);
      EXPECT_EQ(bytesOf(kind, from_front), only.bytes());
    }
  }
}

TEST_F(LimitedImagesTest, WithRoomForAllThePicturesAreThoseWithoutALimitOnceTheImagesAreThere) {
  for (const Method method : kImageMethods) {
    const Frames all = unlimited(method), culled = unlimited(Method::kCulling);
    const Frames some = limited(method, kPlenty);
    std::size_t early = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (some[i] == all[i]) continue;
      ++early;
      EXPECT_LT(i, 8u) << infoOf(method).name;
      EXPECT_EQ(some[i], culled[i]) << "geometry until they are";
    }
    EXPECT_NE(all, culled);
    EXPECT_GT(early, 0u) << "nothing is read before the walk";
  }
}

TEST_F(LimitedImagesTest, WithoutRoomForAnySideEveryPictureIsCullings) {
  for (const Method method : kImageMethods) {
    const Frames culled = unlimited(Method::kCulling);
    EXPECT_EQ(limited(method, 0), culled);
    EXPECT_EQ(limited(method, 1000), culled);
  }
}

TEST_F(LimitedImagesTest, TheSameFramesWhateverTheThreadsAndTheDiskDo) {
  for (const Method method : kImageMethods) {
    const std::size_t most = oneSide(infoOf(method).image_kind);
    const Frames frames = limited(method, most);
    EXPECT_NE(frames, unlimited(Method::kCulling));
    EXPECT_EQ(limited(method, most, 3), frames);
    const auto slow = [](const SideFiles& files, ImageKind kind, SideImages& images) {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      readSideImages(files, kind, images);
    };
    EXPECT_EQ(limited(method, most, 2, slow), frames);
  }
}

TEST_F(LimitedImagesTest, NeverMoreThanTheLimitIsThereOrBeingRead) {
  const std::size_t most = oneSide(ImageKind::kLdi);
  LimitedImages images(*house_, here_->path(), most, Pace::kByFrames);
  FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, 1);
  painter.setLimited(&images);
  std::size_t shown_front = 0, shown_back = 0, lacking = 0;
  for (std::size_t i = 0; i < walk().frames(); ++i) {
    const FrameCost cost = frame(painter, Method::kLdi, i).second;
    EXPECT_LE(images.store().bytes(), most);
    EXPECT_EQ(*cost.image_bytes, images.store().bytes());
    const std::size_t front = images.images().side(0, true).bytes();
    const std::size_t back = images.images().side(0, false).bytes();
    EXPECT_LE(front + back, images.store().bytes());
    EXPECT_TRUE(front == 0 || back == 0) << "there is room for one";
    shown_front += front > 0;
    shown_back += back > 0;
    lacking += *cost.portals_lacking_image;
  }
  EXPECT_GT(shown_front, 0u);
  EXPECT_GT(shown_back, 0u);
  EXPECT_GT(lacking, 0u);
}

TEST_F(LimitedImagesTest, FramesPaintedAgainInAnyOrderAreTheSame) {
  for (const Method method : {Method::kTexture, Method::kLdi}) {
    LimitedImages images(*house_, here_->path(), oneSide(infoOf(method).image_kind),
                         Pace::kByFrames);
    FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, 1);
    painter.setLimited(&images);
    const Frames first = framesOf(painter, method);
    painter.repeatFrames();
    for (std::size_t i = first.size(); i-- > 0;) {
      EXPECT_EQ(frame(painter, method, i).first, first[i]) << i;
    }
    EXPECT_EQ(framesOf(painter, method), first) << "a new walk";
  }
}

TEST_F(LimitedImagesTest, MethodsPlayedInTurnHaveTheFramesThatEachHasAlone) {
  const std::size_t most = oneSide(ImageKind::kReference);
  LimitedImages images(*house_, here_->path(), most, Pace::kByFrames);
  FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, 1);
  painter.setLimited(&images);
  const std::vector<Method> methods = {Method::kWarp, Method::kWarp2, Method::kTexture};
  std::vector<Frames> alone, in_turn(methods.size());
  for (const Method method : methods) alone.push_back(limited(method, most));
  for (const Method method : methods) painter.prepare(method);
  for (std::size_t i = 0; i < walk().frames(); ++i) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      in_turn[m].push_back(frame(painter, methods[m], i).first);
      EXPECT_LE(images.store().bytes(), most);
    }
  }
  EXPECT_EQ(in_turn, alone);
}

TEST_F(LimitedImagesTest, WhatComesAsItComesIsNeverWaitedFor) {
  std::counting_semaphore<> disk(0);
  const auto stopped = [&](const SideFiles& files, ImageKind kind, SideImages& images) {
    disk.acquire();
    readSideImages(files, kind, images);
  };
  LimitedImages images(*house_, here_->path(), kPlenty, Pace::kAsItComes, stopped);
  FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, 1);
  painter.setLimited(&images);
  const Frames culled = unlimited(Method::kCulling);
  for (std::size_t i = 0; i < walk().frames(); ++i) {  // any wait would last for ever
    EXPECT_EQ(frame(painter, Method::kLdi, i).first, culled[i]);
  }
  EXPECT_TRUE(images.isLoading());
  disk.release(10);
  const std::size_t last = walk().frames() - 1;
  while (images.isLoading()) frame(painter, Method::kLdi, last);
  FramePainter baked(*gl_, *house_, *baked_, kWidth, kHeight, 1);
  for (const std::size_t i : {std::size_t{0}, last / 2, last}) {
    EXPECT_EQ(frame(painter, Method::kLdi, i).first, frame(baked, Method::kLdi, i).first);
  }
}

TEST_F(LimitedImagesTest, TwoMethodsShownAtOnceShareTheLimitAndComeToRest) {
  const std::size_t most = 2 * oneSide(ImageKind::kTexture);
  LimitedImages images(*house_, here_->path(), most, Pace::kAsItComes);
  FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, 1);
  painter.setLimited(&images);
  for (int i = 0; i < 2000; ++i) {
    for (const Method method : {Method::kLdi, Method::kTexture}) frame(painter, method, 5);
    EXPECT_LE(images.store().bytes(), most);
    if (i > 10 && !images.isLoading()) break;
  }
  EXPECT_FALSE(images.isLoading());
  const std::size_t kept = images.store().bytes();
  for (int i = 0; i < 20; ++i) {
    for (const Method method : {Method::kLdi, Method::kTexture}) frame(painter, method, 5);
  }
  EXPECT_EQ(images.store().bytes(), kept);
  EXPECT_FALSE(images.isLoading()) << "what one has, the other does not take";
}

TEST_F(LimitedImagesTest, AnImageThatCannotBeReadEndsAScriptedWalkAndIsToldInAWindow) {
  const auto damaged = [](const SideFiles& files, ImageKind, SideImages&) {
    throw Error(ErrorKind::kBadInput, files.folder + "/ldi.bin", "is damaged");
  };
  EXPECT_THROW(limited(Method::kLdi, kPlenty, 1, damaged), Error);

  LimitedImages images(*house_, here_->path(), kPlenty, Pace::kAsItComes, damaged);
  FramePainter painter(*gl_, *house_, images.images(), kWidth, kHeight, 1);
  painter.setLimited(&images);
  const Frames culled = unlimited(Method::kCulling);
  std::vector<std::string> complaints;
  for (int round = 0; round < 20; ++round) {
    do EXPECT_EQ(frame(painter, Method::kLdi, 0).first, culled[0]);
    while (images.isLoading());
    while (const auto complaint = images.complaint()) complaints.push_back(*complaint);
  }
  EXPECT_EQ(complaints.size(), 2u) << "each side once";
  EXPECT_NE(complaints[0].find("/ldi.bin: is damaged"), std::string::npos);
}

TEST_F(LimitedImagesTest, ItIsToldWhatIsTooLargeToBeShown) {
  LimitedImages images(*house_, here_->path(), 1 << 10, Pace::kByFrames);
  EXPECT_EQ(images.noteOnTooLarge({false, false, true}), "") << "nobody has looked";
  images.lookAt(ImageKind::kLdi);
  EXPECT_TRUE(images.noteOnTooLarge({false, false, true}).starts_with("2 sides of portals "));
  EXPECT_EQ(images.noteOnTooLarge({true, false, false}), "");
}

}  // namespace
}  // namespace enfilade
