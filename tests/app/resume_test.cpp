// Preprocessing that is killed, and goes on.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>

#include "portals/house.h"
#include "tests/app/resume_model.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

class Resume : public ResumeTest {};

/// How long an undisturbed run takes [s].
double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// How many times to kill: more by hand, ENFILADE_KILLS=100.
int killsAskedFor() {
  const char* asked = std::getenv("ENFILADE_KILLS");
  return asked != nullptr ? std::atoi(asked) : 4;
}

TEST_F(Resume, KilledAtRandomMomentsAndStartedAgainItEndsWithTheSameBytes) {
  const std::vector<std::string> command = job("house");
  const double whole = secondsOf([&] { run(command); });
  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> moment(0, whole);
  int before = 0, baking = 0, after = 0, same = 0;
  std::size_t kept = 0;
  const int kills = killsAskedFor();
  for (int i = 0; i < kills; ++i) {
    fs::remove_all(path("house"));
    RunningProgram program(command, here_->path());
    // Every other one while it bakes, or thereabouts.
    const bool bakes = i % 2 == 1;
    if (bakes) program.waitUntil([] { return isHouse(unfinishedFolder(path("house"))); });
    const double seconds = (bakes ? 0.5 : 1) * moment(random);
    SCOPED_TRACE("killed after " + std::to_string(seconds) + " s");
    usleep(static_cast<useconds_t>(seconds * 1e6));
    program.send(SIGKILL);
    program.wait();
    const bool complete = isHouse(path("house"));
    const bool found = isHouse(unfinishedFolder(path("house")));
    (complete ? after : found ? baking : before) += 1;
    const auto images = complete ? std::map<std::string, ino_t>() : finishedImages();
    kept += images.size();
    const ProgramResult again = run(command);
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(again.errors.find("voxelise") == std::string::npos, found && !complete)
        << "cells are found once";
    expectNotBakedAgain(images);
    expectAsUndisturbed("house");
    same += filesBelow("house") == *undisturbed_;
  }
  std::printf(
      "%d kills in %.1f s: %d before the cells were found, %d while baking, %d after the end; %zu "
      "images kept; %d ended with the same bytes\n",
      kills, whole, before, baking, after, kept, same);
}

TEST_F(Resume, KilledAgainAndAgainInTheSameWorkItEndsWithTheSameBytes) {
  const std::vector<std::string> command = job("house");
  for (std::size_t sides = 1; sides <= 7; sides += 3) {
    RunningProgram program(command, here_->path());
    const bool baked = program.waitUntil([&] { return finishedImages().size() >= 8 * sides; });
    EXPECT_TRUE(baked) << program.errors();
    const auto images = finishedImages();
    program.send(SIGKILL);
    program.wait();
    EXPECT_GE(finishedImages().size(), images.size());
  }
  const auto images = finishedImages();
  const ProgramResult last = run(job("house", "1"));  // by another number of threads
  EXPECT_EQ(last.status, 0);
  EXPECT_NE(last.errors.find("\ngoes on: "), std::string::npos) << last.errors;
  expectNotBakedAgain(images);
  expectAsUndisturbed("house");
}

/// Starts the work and kills it when some sides are finished.
class HalfDone : public ResumeTest {
 protected:
  static void leaveHalf(const std::vector<std::string>& command) {
    RunningProgram program(command, here_->path());
    ASSERT_TRUE(program.waitUntil([] { return finishedImages().size() >= 16; }))
        << program.errors();
    program.send(SIGKILL);
    program.wait();
  }
  static void damage(const std::string& file) {
    std::string bytes = textOf(file);
    bytes[bytes.size() / 2] ^= 1;
    writeText(file, bytes);
  }
  /// The same work, from the start because of `reason`.
  static void expectBegunAfresh(const std::string& reason) {
    const ProgramResult result = run(job("house"));
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.errors.find("cannot be gone on with: " + reason), std::string::npos)
        << result.errors;
    expectAsUndisturbed("house");
  }
};

TEST_F(HalfDone, OtherParametersBeginAfreshAndSayWhy) {
  leaveHalf(with(job("house"), "--image-size", "63"));
  const ProgramResult result = run(job("house"));
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.errors.find("house/unfinished: cannot be gone on with: image_size_px was '63', "
                               "is '64'\n"),
            std::string::npos)
      << result.errors;
  expectAsUndisturbed("house");
}

TEST_F(HalfDone, AnotherModelBeginsAfresh) {
  fs::copy(path("rooms.glb"), path("original"));
  Building building = roomRow();
  building.nodes[0].world_from_node[3].x += 0.05f;
  writeGlb(path("rooms.glb"), building);
  leaveHalf(job("house"));
  fs::copy(path("original"), path("rooms.glb"), fs::copy_options::overwrite_existing);
  expectBegunAfresh("the model has changed");
}

TEST_F(HalfDone, AnOlderHouseStaysWholeUntilTheNewOneTakesItsPlace) {
  ASSERT_EQ(run(with(job("house"), "--image-size", "24")).status, 0);
  const Files old = filesBelow("house");
  leaveHalf(job("house"));
  Files now = filesBelow("house");
  std::erase_if(now, [](const auto& file) { return file.first.starts_with("unfinished"); });
  EXPECT_EQ(now, old);
  EXPECT_EQ(run({"inspect", "house"}).status, 0);
  EXPECT_EQ(run(job("house")).status, 0);
  expectAsUndisturbed("house");
}

TEST_F(HalfDone, AHouseThatIsNotThereYetIsNamedAsSuch) {
  leaveHalf(job("house"));
  const ProgramResult result = run({"tour", "house", "-o", "tour.json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "enfilade: house: is a house that is not yet finished: let its 'enfilade preprocess' "
            "come to its end, or give the same again if it was stopped\n");
}

TEST_F(HalfDone, DamagedWorkIsMadeAfresh) {
  leaveHalf(job("house"));
  damage(geometryFile(unfinishedFolder(path("house"))));
  expectBegunAfresh("house/unfinished/geometry.glb: is cut short, damaged");
}

TEST_F(HalfDone, ASideWithADamagedImageIsBakedAgain) {
  leaveHalf(job("house"));
  damage(path("house/unfinished/") + finishedImages().begin()->first);
  EXPECT_EQ(run(job("house")).status, 0);
  expectAsUndisturbed("house");
}

TEST_F(HalfDone, WhatAPowerCutEmptiedIsNotPutInPlace) {
  ASSERT_EQ(run(with(job("house"), "--image-size", "24")).status, 0);
  leaveHalf(job("house"));
  const auto images = finishedImages();
  writeText(path("house/unfinished/finished.json"), "");
  const ProgramResult result = run(job("house"));
  EXPECT_EQ(result.status, 0) << result.errors;
  expectNotBakedAgain(images);
  expectAsUndisturbed("house");
}

TEST_F(HalfDone, KilledWhenAllIsInItsPlaceNothingIsMadeAgain) {
  leaveHalf(job("house"));
  const std::string unfinished = path("house/unfinished"), aside = path("aside");
  fs::create_directory(aside);
  for (const char* file : {"/job.json", "/house.json"}) fs::copy(unfinished + file, aside + file);
  ASSERT_EQ(run(job("house")).status, 0);
  fs::rename(aside, unfinished);
  const auto written = fs::last_write_time(path("house/geometry.glb"));
  const ProgramResult result = run(job("house"));
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors.find("cannot be gone on with"), std::string::npos) << result.errors;
  EXPECT_EQ(fs::last_write_time(path("house/geometry.glb")), written);
  expectAsUndisturbed("house");
  EXPECT_FALSE(fs::exists(unfinished));
}

TEST_F(HalfDone, TheModelIsNotReplacedByItsHouse) {
  fs::create_directory(path("house"));
  fs::copy(path("rooms.glb"), path("house/geometry.glb"));
  std::vector<std::string> command = job("house");
  command[1] = "house/geometry.glb";
  const ProgramResult result = run(command);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("house/geometry.glb: would be replaced"), std::string::npos)
      << result.errors;
  EXPECT_EQ(textOf(path("house/geometry.glb")), textOf(path("rooms.glb")));
}

TEST_F(HalfDone, WhatIsOddAboutTheModelIsSaidAgain) {
  Building building = roomRow();
  for (Node& node : building.nodes) node.world_from_node[3].x += 50'000;
  writeGlb(path("far.glb"), building);
  std::vector<std::string> command = job("house");
  command[1] = "far.glb";
  leaveHalf(command);
  const ProgramResult again = run(command);
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.errors.find("50 km from the origin"), std::string::npos) << again.errors;
  EXPECT_NE(again.errors.find("\ngoes on: "), std::string::npos) << again.errors;
}

TEST_F(HalfDone, OtherThingsInItAreNotRemoved) {
  leaveHalf(job("house"));
  writeText(path("house/unfinished/thesis"), "irreplaceable");
  const ProgramResult result = run(with(job("house"), "--image-size", "24"));
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("holds other things (thesis)"), std::string::npos) << result.errors;
  EXPECT_EQ(textOf(path("house/unfinished/thesis")), "irreplaceable");
}

}  // namespace
}  // namespace enfilade
