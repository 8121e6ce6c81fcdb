// The thread that reads images, and what is not waited for.
#include "app/side_reader.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "scene/error.h"

namespace enfilade {
namespace {

/// A disk that is stopped until it is let go.
class Gate {
 public:
  void pass() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return open_ > 0; });
    --open_;
  }
  void letThrough(int many) {
    const std::lock_guard lock(mutex_);
    open_ += many;
    changed_.notify_all();
  }
  void awaitReader(int count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_ >= count; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_ = 0, open_ = 0;
};

/// Images that can be told apart by their number.
SideImages imagesOf(std::size_t number) {
  SideImages images;
  images.textures.resize(1);
  images.textures[0] = {1, 1, {static_cast<std::uint8_t>(number), 0, 0, 0}};
  return images;
}

TEST(SideReader, ReadsWhatIsAskedForInOrder) {
  SideReader reader(imagesOf);
  for (std::size_t i = 0; i < 50; ++i) reader.ask(i);
  std::size_t next = 0;
  while (next < 50) {
    for (const SideReader::Result& result : reader.waitForSome()) {
      EXPECT_EQ(result.asked, next++);
      EXPECT_EQ(result.images.textures[0].rgba[0], result.asked);
    }
  }
  EXPECT_TRUE(reader.results().empty());
}

TEST(SideReader, NoCallWaitsWhileTheDiskDoes) {
  Gate gate;
  SideReader reader([&](std::size_t i) { return gate.pass(), imagesOf(i); });
  reader.ask(1);
  gate.awaitReader(1);
  reader.ask(2);
  reader.takeBack(2);
  reader.ask(3);
  reader.free(imagesOf(9));
  EXPECT_TRUE(reader.results().empty());  // all of this would hang otherwise
  gate.letThrough(2);
  std::vector<std::size_t> read;
  while (read.size() < 2) {
    for (const auto& result : reader.waitForSome()) read.push_back(result.asked);
  }
  EXPECT_EQ(read, (std::vector<std::size_t>{1, 3}));
}

TEST(SideReader, WhatIsTakenBackNeverComesWhetherItWaitsIsReadOrWasRead) {
  Gate gate;
  SideReader reader([&](std::size_t i) { return gate.pass(), imagesOf(i); });
  for (const std::size_t i : {1u, 2u, 3u, 4u}) reader.ask(i);
  gate.letThrough(1);
  gate.awaitReader(2);  // 1 was read, 2 is being read, 3 waits
  for (const std::size_t i : {1u, 2u, 3u}) reader.takeBack(i);
  gate.letThrough(2);
  const auto results = reader.waitForSome();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].asked, 4u);
}

TEST(SideReader, WhatIsAskedForAgainWhileItIsReadComesOnce) {
  Gate gate;
  SideReader reader([&](std::size_t i) { return gate.pass(), imagesOf(i); });
  reader.ask(1);
  gate.awaitReader(1);
  reader.takeBack(1);
  reader.ask(1);
  gate.letThrough(2);
  EXPECT_EQ(reader.waitForSome().size(), 1u);
  EXPECT_TRUE(reader.results().empty());
}

TEST(SideReader, WhatReadingThrowsIsInTheResult) {
  SideReader reader([](std::size_t) -> SideImages {
    throw Error(ErrorKind::kBadInput, "ldi.bin", "is damaged");
  });
  reader.ask(5);
  const auto results = reader.waitForSome();
  ASSERT_EQ(results.size(), 1u);
  EXPECT_THROW(std::rethrow_exception(results[0].failure), Error);
}

TEST(SideReader, EndsWhileMuchIsAskedFor) {
  std::atomic<int> read = 0;
  {
    SideReader reader([&](std::size_t i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++read;
      return imagesOf(i);
    });
    for (std::size_t i = 0; i < 10'000; ++i) reader.ask(i);
  }
  EXPECT_LT(read, 10'000);
}

}  // namespace
}  // namespace enfilade
