#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <map>
#include <memory>

#include "scene/gltf_writer.h"
#include "tests/app/run_program.h"
#include "tests/app/running_program.h"
#include "tests/preprocess/test_building.h"

namespace enfilade {

/// Four rooms in a row, a doorway between each two and a window in each.
inline Building roomRow() {
  constexpr int kRooms = 4;
  constexpr float kEnd = 4.0f * kRooms;
  TestBuilding test;
  test.slab(-0.2f, -0.2f, kEnd + 0.2f, 4.2f, 0.0f);
  test.slab(-0.2f, -0.2f, kEnd + 0.2f, 4.2f, 3.2f);
  std::vector<TestBuilding::Hole> windows;
  for (int i = 0; i < kRooms; ++i) {
    const float x = 4.0f * static_cast<float>(i);
    windows.push_back({x + 1, x + 3, 0.9f, 2.1f});
    const bool outer = i == 0;
    test.wall(false, x, 0, 4, 0, 3,
              outer ? std::vector<TestBuilding::Hole>{}
                    : std::vector<TestBuilding::Hole>{{1.5f, 2.5f, 0, 2.1f}});
    test.box({x + 2.5f, 0, 3}, {x + 3, 0.3f + 0.3f * static_cast<float>(i), 3.5f});
  }
  test.wall(false, kEnd, 0, 4, 0, 3);
  test.wall(true, 0, 0, kEnd, 0, 3, windows);
  test.wall(true, 4, 0, kEnd, 0, 3);
  return test.building;
}

/// Runs of `enfilade preprocess` on that row that do not come to their end, and one that did.
class ResumeTest : public ::testing::Test {
 protected:
  using Files = std::map<std::string, std::string>;
  static constexpr const char* kLongStage = "100000000";  // sight lines

  static void SetUpTestSuite() {
    here_ = std::make_unique<TemporaryFolder>();
    writeGlb(path("rooms.glb"), roomRow());
    const ProgramResult result = runEnfilade(job("undisturbed", "1"), here_->path());
    ASSERT_EQ(result.status, 0) << result.errors;
    undisturbed_ = std::make_unique<Files>(filesBelow("undisturbed"));
  }
  static void TearDownTestSuite() {
    undisturbed_.reset();
    here_.reset();
  }
  ~ResumeTest() override { std::filesystem::remove_all(path("house")); }

  static std::vector<std::string> job(const std::string& house, const std::string& threads = "2") {
    return {"preprocess",
            "rooms.glb",
            "-o",
            house,
            "--image-size",
            "64",
            "--captures",
            "ring:3",
            "--bake",
            "texture,warp,ldi",
            "-j",
            threads,
            "--textures-per-portal",
            "4",
            "--images-per-portal",
            "3",
            "--sight-lines",
            "2000"};
  }
  /// `arguments` with another value for an option.
  static std::vector<std::string> with(std::vector<std::string> arguments,
                                       const std::string& option, const std::string& value) {
    const auto at = std::find(arguments.begin(), arguments.end(), option);
    if (at == arguments.end()) {
      arguments.insert(arguments.end(), {option, value});
    } else {
      at[1] = value;
    }
    return arguments;
  }
  static ProgramResult run(const std::vector<std::string>& arguments) {
    return runEnfilade(arguments, here_->path());
  }
  static std::string path(const std::string& name) { return *here_ / name; }

  /// Every file below a folder by its path there, with its bytes.
  static Files filesBelow(const std::string& folder) {
    Files files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      const std::string name = std::filesystem::relative(entry.path(), path(folder)).string();
      files[name] = entry.is_regular_file() ? textOf(entry.path().string()) : "folder";
    }
    return files;
  }
  static void expectAsUndisturbed(const std::string& folder) {
    const Files files = filesBelow(folder);
    EXPECT_EQ(files.size(), undisturbed_->size());
    for (const auto& [name, bytes] : *undisturbed_) {
      EXPECT_TRUE(files.contains(name) && files.at(name) == bytes) << name;
    }
  }

  /// The images of the sides that are finished in house/unfinished, by their name in a house: which
  /// file on the disk each is.
  static std::map<std::string, ino_t> finishedImages() {
    std::map<std::string, ino_t> images;
    std::error_code gone;  // what is looked at while the program is at work
    const std::string folder = path("house/unfinished");
    for (std::filesystem::directory_iterator side(folder + "/sides", gone), end;
         !gone && side != end; side.increment(gone)) {
      const std::string name = "images/" + side->path().filename().string();
      if (name.find(".tmp-") != std::string::npos) continue;
      for (const auto& image : std::filesystem::directory_iterator(folder + "/" + name)) {
        struct stat status {};
        if (stat(image.path().c_str(), &status) == 0) {
          images[name + "/" + image.path().filename().string()] = status.st_ino;
        }
      }
    }
    return images;
  }
  static void expectNotBakedAgain(const std::map<std::string, ino_t>& images) {
    for (const auto& [name, inode] : images) {
      struct stat status {};
      EXPECT_EQ(stat(path("house/" + name).c_str(), &status), 0) << name;
      EXPECT_EQ(status.st_ino, inode) << name << " was baked again";
    }
  }

  static std::unique_ptr<TemporaryFolder> here_;
  static std::unique_ptr<Files> undisturbed_;
};
inline std::unique_ptr<TemporaryFolder> ResumeTest::here_;
inline std::unique_ptr<ResumeTest::Files> ResumeTest::undisturbed_;

}  // namespace enfilade
