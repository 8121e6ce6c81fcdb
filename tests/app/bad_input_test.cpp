// What the built program says and does when it is given something wrong: one line on stderr, the
// right exit status, nothing written.
#include <gtest/gtest.h>

#include "portals/house.h"
#include "scene/camera_path.h"
#include "scene/gltf_writer.h"
#include "tests/app/run_program.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

using Arguments = std::vector<std::string>;

class BadInput : public ::testing::Test {
 protected:
  BadInput() {
    const House house = twoRoomHouse();
    writeHouse(here_ / "house", house);
    writeGlb(here_ / "model.glb", house.building);
    const std::string model = textOf(here_ / "model.glb");
    writeText(here_ / "truncated.glb", model.substr(0, model.size() / 2));
    writeText(here_ / "text.glb", "Dear diary, today I renamed a text file.\n");
    writeText(here_ / "empty.glb", "");
    writeText(here_ / "nothing.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{}]})");
    writeText(here_ / "table.csv", "a,b,c\n1,2,3\n");
    writeText(here_ / "tour.json", R"({"enfilade": "tour", "version": 99})");
    std::filesystem::create_directory(here_ / "folder");
    writeText(here_ / "folder/thesis", "irreplaceable");
    std::filesystem::copy(here_ / "house", here_ / "cut", std::filesystem::copy_options::recursive);
    const std::string json = textOf(here_ / "cut/house.json");
    writeText(here_ / "cut/house.json", json.substr(0, json.size() / 2));
    before_ = here_.tree();
  }

  /// Runs the program and expects it to refuse with `status` in one line that holds `reason`.
  void expectRefusal(const Arguments& arguments, int status, const std::string& reason) {
    const ProgramResult result = runEnfilade(arguments, here_.path());
    std::string line = "enfilade";
    for (const std::string& argument : arguments) line += " " + argument;
    SCOPED_TRACE(line);
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(result.output, "");
    EXPECT_TRUE(result.errors.starts_with("enfilade: ")) << result.errors;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_NE(result.errors.find(reason), std::string::npos) << result.errors;
    EXPECT_EQ(here_.tree(), before_) << "something was written";
  }

  TemporaryFolder here_;
  std::vector<std::string> before_;
};

TEST_F(BadInput, ACommandLineThatMakesNoSense) {
  expectRefusal({}, 1, "there are: sample, inspect, preprocess, tour, play");
  expectRefusal({"bake"}, 1, "bake: no such command; there are: sample");
  expectRefusal({"--verbose"}, 1, "--verbose: no such option; there are: ");
  expectRefusal({"--quiet", "play", "house", "-o", "r"}, 1,
                "--quiet: belongs behind the command: enfilade play … --quiet");
  expectRefusal({"play", "house", "-o", "r", "--fast"}, 1, "--fast: no such option; there are: ");
  expectRefusal({"play", "house"}, 1, "--output is required");
  expectRefusal({"tour"}, 1, "HOUSE is required");
  expectRefusal({"inspect", "model.glb", "second.glb"}, 1, "second.glb: one argument too many");
  expectRefusal({"tour", "house", "-o", "t.json", "--frames", "many"}, 1, "'many' is no number");
  expectRefusal({"tour", "house", "-o", "t.json", "--frames", "1"}, 1, "1 is not from 2 to");
  expectRefusal({"tour", "house", "-o", "t.json", "--format", "obj"}, 1, "json");
  expectRefusal({"preprocess", "model.glb", "-o", "h", "--voxel", "0"}, 1, "0.02 to 1");
}

TEST_F(BadInput, AModelThatIsNone) {
  for (const Arguments& command : {Arguments{"inspect"}, Arguments{"preprocess", "-o", "new"}}) {
    const auto expect = [&](const std::string& model, const std::string& reason) {
      Arguments arguments = command;
      arguments.push_back(model);
      expectRefusal(arguments, 2, model + ": " + reason);
    };
    expect("missing.glb", "no such file");
    expect("folder", command[0] == "inspect" ? "is not a house" : "is a directory");
    expect("text.glb", "");
    expect("empty.glb", "");
    expect("truncated.glb", "");
    expect("nothing.gltf", "");
    expect("table.csv", "");
  }
}

TEST_F(BadInput, AHouseThatIsNone) {
  for (const Arguments& command :
       {Arguments{"inspect"}, Arguments{"tour", "-o", "new"}, Arguments{"play", "-o", "new"}}) {
    const auto expect = [&](const std::string& house, const std::string& reason) {
      Arguments arguments = command;
      arguments.push_back(house);
      expectRefusal(arguments, 2, reason);
    };
    expect("missing", "missing: no such file");
    expect("folder", "folder: is not a house");
    expect("cut", "cut/house.json: ");
  }
}

TEST_F(BadInput, AMethodThatThereIsNot) {
  expectRefusal(
      {"play", "house", "-o", "new", "--methods", "culling,magic"}, 1,
      "'magic': no such method; there are: geometry, raycast, culling, texture, warp, warp2, ldi");
}

TEST_F(BadInput, AMethodThatNeedsImagesOfAHouseWithoutThem) {
  expectRefusal({"play", "house", "-o", "new", "--quiet", "--methods", "ldi"}, 2,
                "house: has no images for the method ldi");
  expectRefusal({"play", "house", "-o", "new", "--quiet", "--methods", "culling,warp2"}, 2,
                "house: has no images for the method warp2, which shows reference images; "
                "preprocess the model again with --bake texture,warp,ldi, or play with --images "
                "on-demand");
}

TEST_F(BadInput, ASourceOrAKindOfImagesThatThereIsNot) {
  expectRefusal({"play", "house", "-o", "new", "--images", "sometimes"}, 1,
                "--images sometimes: no such source; there are: baked, on-demand");
  expectRefusal({"preprocess", "model.glb", "-o", "new", "--bake", "ldi,magic"}, 1,
                "'magic': no such kind of image; there are: texture, warp, ldi");
}

TEST_F(BadInput, AnOpenGlThatThereIsNot) {
  expectRefusal({"play", "house", "-o", "new", "--gl", "magic"}, 1,
                "--gl magic: no such OpenGL; there are: osmesa, egl");
  expectRefusal({"preprocess", "model.glb", "-o", "new", "--gl", "magic"}, 1, "--gl magic: ");
}

TEST_F(BadInput, ATourOfAnotherFormat) {
  const Arguments play = {"play", "house", "-o", "new", "--methods", "culling", "--tour"};
  for (const char* tour : {"table.csv", "tour.json", "missing.json", "folder", "model.glb"}) {
    Arguments arguments = play;
    arguments.emplace_back(tour);
    expectRefusal(arguments, 2, std::string(tour) + ": ");
  }
}

TEST_F(BadInput, AnOutputThatCannotBeWritten) {
  expectRefusal({"sample", "gallery", "-o", "table.csv/new.glb", "--triangles", "50000"}, 3,
                "table.csv/new.glb: ");
  expectRefusal({"tour", "house", "-o", "table.csv/t.json", "--frames", "2", "-q"}, 3,
                "table.csv/t.json: ");
  expectRefusal({"inspect", "house", "--plan", "table.csv/plan.svg"}, 3, "table.csv/plan.svg: ");
  expectRefusal({"inspect", "house", "--cells", "table.csv/c.glb"}, 3, "table.csv/c.glb: ");
  expectRefusal({"preprocess", "model.glb", "-o", "table.csv/new", "-q"}, 3, "table.csv");
  expectRefusal({"play", "house", "-o", "table.csv/new", "-q", "--methods", "culling"}, 3,
                "table.csv/new: ");
}

TEST_F(BadInput, AnOutputFolderThatHoldsSomethingElse) {
  expectRefusal({"play", "house", "-o", "folder", "-q", "--methods", "culling"}, 1, "folder: ");
  const ProgramResult result =
      runEnfilade({"preprocess", "model.glb", "-o", "folder", "-q"}, here_.path());
  EXPECT_NE(result.status, 0);
  EXPECT_EQ(here_.tree(), before_);
}

TEST_F(BadInput, AnOutputFolderThatIsALinkToNothing) {
  std::filesystem::create_directory_symlink("nowhere", here_ / "new");
  before_.push_back(here_ / "new");
  std::sort(before_.begin(), before_.end());
  expectRefusal({"preprocess", "model.glb", "-o", "new", "-q"}, 1,
                "new: is a symbolic link to nothing");
}

TEST_F(BadInput, AReportThatIsNone) {
  expectRefusal({"report"}, 1, "REPORT is required");
  expectRefusal({"report", "missing"}, 2, "missing: no such file");
  expectRefusal({"report", "folder"}, 2, "folder/summary.json: no such file");
  expectRefusal({"report", "table.csv"}, 2, "table.csv/summary.json: no such file");
  expectRefusal({"report", "house"}, 2, "house/summary.json: no such file");
}

TEST_F(BadInput, ATableOfFramesThatIsBrokenOrAPageThatCannotBeWritten) {
  std::filesystem::create_directory(here_ / "run");
  writeText(here_ / "run/summary.json", R"({"schema": 1, "frames": 1})");
  writeText(here_ / "run/frames.csv", "method,frame,frametime_ms\nldi,0,soon\n");
  before_ = here_.tree();
  expectRefusal({"report", "run", "run"}, 2, "run/frames.csv: line 2: 'soon' in frametime_ms");
  writeText(here_ / "run/frames.csv", "method,frame,frametime_ms\nldi,0,1.5\n");
  expectRefusal({"report", "run", "-o", "new.html"}, 1, "two reports or more");
  expectRefusal({"report", "run", "run", "-o", "folder"}, 1, "is a folder");
  expectRefusal({"report", "run", "run", "-o", "table.csv/new.html"}, 3, "table.csv/new.html: ");
  expectRefusal({"report", "run", "--mangohud", "table.csv/logs"}, 3, "table.csv/logs");
}

TEST_F(BadInput, ASizeThatIsNone) {
  for (const char* size : {"640", "640x", "0x0", "640x512x2", "99999x10", "axb"}) {
    expectRefusal({"play", "house", "-o", "new", "--size", size}, 1, "no size; write WIDTHxHEIGHT");
  }
}

TEST_F(BadInput, AnOptionThatIsGivenTwice) {
  expectRefusal({"play", "house", "-o", "new", "--methods", "culling", "--methods", "ldi"}, 1,
                "--methods is given twice; see 'enfilade play --help'");
}

TEST_F(BadInput, AnOutputThatWouldReplaceTheHouseThatIsPlayed) {
  for (const char* option : {"-o", "--video", "--frames-dir"}) {
    for (const char* output : {"house", "house/images", "house/geometry.glb"}) {
      expectRefusal({"play", "house", option, output}, 1,
                    std::string(output) + ": would be replaced, and is read");
    }
  }
}

TEST_F(BadInput, APlanThatIsBroken) {
  writeText(here_ / "plan.json", R"({"enfilade":"plan")");
  before_ = here_.tree();
  expectRefusal({"sample", "plan.json", "-o", "new.glb"}, 2,
                "plan.json: is not JSON: parse error at line 1, column 19");
}

TEST_F(BadInput, ANameThatIsEmpty) {
  const auto refuse = [&](Arguments arguments, const char* option) {
    arguments.insert(arguments.end(), {option, ""});
    expectRefusal(arguments, 1, std::string(option) + ": the name is empty");
  };
  for (const char* option : {"--plan", "--cells", "--layers"}) refuse({"inspect", "house"}, option);
  for (const char* option : {"--output", "--tour", "--video", "--frames-dir"}) {
    refuse({"play", "house"}, option);
  }
  for (const char* option : {"--output", "--mangohud", "--presentmon"}) {
    refuse({"report", "house", "house"}, option);
  }
  refuse({"preprocess", "model.glb", "-o", "new"}, "--graph");
  refuse({"sample", "gallery", "-o", "new.glb"}, "--furniture");
}

TEST_F(BadInput, AWayOfWarpingThatThereIsNot) {
  const std::pair<const char*, const char*> bad[] = {
      {"--splat", "3x3, cross"}, {"--holes", "none, persist"}, {"--clip", "none, columns, tiles"}};
  for (const auto& [option, there_are] : bad) {
    expectRefusal({"play", "house", "-o", "new", option, "magic"}, 1,
                  std::string(option) + " magic: no such choice");
    expectRefusal({"play", "house", "-o", "new", option, "magic"}, 1, there_are);
  }
}

TEST_F(BadInput, AGraphThatThereIsNotOrThatWouldBeReplaced) {
  const Arguments preprocess = {"preprocess", "model.glb", "-q", "--no-images", "--graph"};
  const auto refuse = [&](const char* graph, const char* output, int status, const char* reason) {
    Arguments arguments = preprocess;
    arguments.insert(arguments.end(), {graph, "-o", output});
    expectRefusal(arguments, status, std::string(graph) + reason);
  };
  refuse("missing.json", "new", 2, ": no such file");
  refuse("table.csv", "new", 2, ": is not JSON");
  refuse("house/house.json", "house", 1, ": would be replaced");
  expectRefusal({"preprocess", "model.glb", "-o", "new", "--auto", "--graph", "house/house.json"},
                1, "--auto");
}

TEST_F(BadInput, ASampleThatThereIsNot) {
  expectRefusal({"sample", "palace", "-o", "new.glb"}, 1, "gallery");
  expectRefusal({"sample", "gallery", "-o", "new.glb", "--triangles", "7"}, 1, "7 is not from");
  expectRefusal({"sample", "haunted", "-o", "new.glb", "--furniture", "table.csv"}, 3,
                "table.csv: cannot be read: Not a directory");
  expectRefusal({"sample", "haunted", "-o", "new.glb", "--furniture", "folder"}, 3,
                "folder: holds no furniture catalogues");
}

TEST_F(BadInput, APlanOfAModel) {
  expectRefusal({"inspect", "model.glb", "--plan", "plan.svg"}, 1, "preprocess it");
  expectRefusal({"inspect", "model.glb", "--cells", "cells.glb"}, 1, "preprocess it");
}

TEST_F(BadInput, LayersThatThereAreNot) {
  expectRefusal({"inspect", "model.glb", "--layers", "new"}, 1, "preprocess it");
  expectRefusal({"inspect", "house", "--layers", "new"}, 2, "house: has no layered depth images");
  expectRefusal({"inspect", "house", "--layers", "new", "--side", "left"}, 1, "left");
  expectRefusal({"inspect", "house", "--portal", "0"}, 1, "--layers");
}

TEST_F(BadInput, APlanOfCapturesThatIsNone) {
  const Arguments preprocess = {"preprocess", "model.glb", "-o", "new", "--captures"};
  for (const char* plan : {"13", "ring", "ring:0", "ring:13,", "ring:6@high", "ring:6/89"}) {
    Arguments arguments = preprocess;
    arguments.emplace_back(plan);
    expectRefusal(arguments, 1, "such as ring:13,ring:6@-0.5/62.5");
  }
  expectRefusal({"preprocess", "model.glb", "-o", "new", "--ldi", "magic"}, 1,
                "--ldi magic: no such way; there are: warp, raycast");
}

}  // namespace
}  // namespace enfilade
