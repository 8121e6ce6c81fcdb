// Preprocessing that is asked to stop, or that the machine stops.
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "portals/house.h"
#include "tests/app/resume_model.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

class StoppedPreprocessing : public ResumeTest {
 protected:
  /// Sends `signal` and expects that the program ends by it, soon.
  static void stopBy(int signal, RunningProgram& program) {
    const auto start = std::chrono::steady_clock::now();
    program.send(signal);
    EXPECT_EQ(program.wait(), 128 + signal) << program.errors();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), 10) << "about one on a machine that has nothing else to do";
  }
  static void expectNothingHalfWritten() {
    for (const auto& [name, bytes] : filesBelow("house")) {
      EXPECT_EQ(name.find(".tmp-"), std::string::npos) << name;
      EXPECT_EQ(name.find(".part"), std::string::npos) << name;
    }
  }
  static bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(StoppedPreprocessing, SaysWhatIsFinishedAndGoesOnFromThere) {
  for (const int signal : {SIGINT, SIGTERM}) {
    RunningProgram program(job("house"), here_->path());
    ASSERT_TRUE(program.waitUntil([] { return finishedImages().size() >= 8; })) << program.errors();
    stopBy(signal, program);
    const std::string said = program.errors();
    EXPECT_TRUE(says(said, "\nenfilade: stopped: ") &&
                says(said,
                     " portal sides are finished and kept in house/unfinished: the same "
                     "command goes on from there\n"))
        << said;
    expectNothingHalfWritten();
    EXPECT_FALSE(isHouse(path("house")));
    const auto images = finishedImages();
    EXPECT_GE(images.size(), 8u);
    const ProgramResult again = run(job("house"));
    EXPECT_EQ(again.status, 0) << again.errors;
    const std::size_t count_at = said.rfind("stopped: ") + 9;
    const std::string counted = said.substr(count_at, said.rfind(": the same") - count_at);
    EXPECT_TRUE(says(again.errors, "goes on: " + counted + "\n")) << again.errors;
    expectNotBakedAgain(images);
    expectAsUndisturbed("house");
    fs::remove_all(path("house"));
  }
}

TEST_F(StoppedPreprocessing, BeforeTheCellsAreFoundLeavesNothing) {
  RunningProgram program(with(job("house"), "--sight-lines", kLongStage), here_->path());
  ASSERT_TRUE(program.waitUntil([&] { return says(program.errors(), "find cells and portals"); }));
  stopBy(SIGINT, program);
  EXPECT_TRUE(says(program.errors(),
                   "\nenfilade: stopped: nothing was finished yet, and nothing is kept\n"))
      << program.errors();
  EXPECT_FALSE(fs::exists(path("house")));
}

TEST_F(StoppedPreprocessing, ASecondRunInTheSameFolderIsToldUntilTheFirstIsGone) {
  RunningProgram first(with(job("house"), "--sight-lines", kLongStage), here_->path());
  ASSERT_TRUE(first.waitUntil([&] { return says(first.errors(), "find cells and portals"); }));
  const ProgramResult second = run(job("house"));
  EXPECT_EQ(second.status, 3);
  EXPECT_EQ(second.errors,
            "enfilade: house: is in use: another enfilade preprocess is at work there; wait for "
            "its end, or choose another folder\n");
  first.send(SIGKILL);
  first.wait();
  const ProgramResult third = run(job("house"));
  EXPECT_EQ(third.status, 0) << third.errors;
  expectAsUndisturbed("house");
}

/// Files cannot become larger than `bytes`: what a full disk looks like to the program.
std::function<void()> filesUpTo(rlim_t bytes) {
  return [bytes] {
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_IGN);
  };
}

TEST_F(StoppedPreprocessing, WhatCannotBeWrittenIsToldAndGoneOnWithWhenThereIsRoom) {
  const auto large = with(job("house"), "--image-size", "160");
  rlim_t largest = 0;
  for (const char* part : {"geometry.glb", "cells.grid", "house.json"}) {
    largest = std::max(largest, static_cast<rlim_t>(undisturbed_->at(part).size()));
  }
  RunningProgram program(large, here_->path(), filesUpTo(largest + 1000));
  EXPECT_EQ(program.wait(), 3);
  const std::string said = program.errors();
  const std::string last = said.substr(said.rfind("enfilade: "));
  EXPECT_TRUE(last.starts_with("enfilade: house/unfinished/images/portal-")) << last;
  EXPECT_TRUE(says(last, ": cannot be written: File too large; ")) << last;
  EXPECT_TRUE(
      last.ends_with(" portal sides are finished and kept in house/unfinished: the same "
                     "command goes on from there\n"))
      << last;
  expectNothingHalfWritten();
  const auto images = finishedImages();
  EXPECT_EQ(run(large).status, 0);
  expectNotBakedAgain(images);
  EXPECT_EQ(run(with(large, "-o", "elsewhere")).status, 0);
  EXPECT_EQ(filesBelow("house"), filesBelow("elsewhere"));
}

TEST_F(StoppedPreprocessing, WithNoRoomForTheCellsLeavesNothing) {
  RunningProgram program(job("house"), here_->path(), filesUpTo(2000));
  EXPECT_EQ(program.wait(), 3);
  EXPECT_TRUE(says(program.errors(), "\nenfilade: house/unfinished/")) << program.errors();
  EXPECT_TRUE(program.errors().ends_with(": cannot be written: File too large\n"))
      << program.errors();
  EXPECT_FALSE(fs::exists(path("house")));
}

TEST_F(StoppedPreprocessing, AFolderThatCannotBeWrittenToIsTold) {
  const bool root = geteuid() == 0;  // who may write to any folder, but not make one there
  const std::string folder = root ? "/proc/house" : path("house");
  if (!root) {
    fs::create_directory(folder);
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  }
  const ProgramResult result = run(job(folder));
  EXPECT_EQ(result.status, 3);
  EXPECT_TRUE(result.errors.starts_with("enfilade: " + folder + ": cannot be ")) << result.errors;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
}

}  // namespace
}  // namespace enfilade
