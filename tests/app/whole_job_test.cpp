// The built program's main job from end to end, on a small model: preprocess, inspect, tour, play.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/contact_sheet.h"
#include "app/image_quality.h"
#include "scene/camera_path.h"
#include "scene/gltf_writer.h"
#include "tests/app/run_program.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;
namespace fs = std::filesystem;

constexpr const char* kAllMethods = "geometry,raycast,culling,texture,warp,warp2,ldi";

class WholeJob : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    here_ = std::make_unique<TemporaryFolder>();
    writeGlb(*here_ / "model.glb", twoRoomHouse().building);
    preprocessed_ = run({"preprocess", "model.glb", "-o", "house", "--image-size", "32",
                         "--captures", "ring:3", "--bake", "texture,warp,ldi",
                         "--textures-per-portal", "5", "--sight-lines", "5000", "-j", "2"});
    toured_ = run({"tour", "house", "-o", "tour.json", "--frames", "12", "-q"});
    played_ =
        run({"play", "house", "--tour", "tour.json", "--methods", kAllMethods, "--size", "80x64",
             "--quality", "--frames-dir", "frames", "--threads", "2", "-o", "report"});
  }
  static void TearDownTestSuite() { here_.reset(); }

  static ProgramResult run(const Arguments& arguments) {
    return runEnfilade(arguments, here_->path());
  }
  static std::string path(const std::string& name) { return *here_ / name; }

  /// Every file below a folder by its path there, with its bytes.
  static std::map<std::string, std::string> bytesBelow(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (!entry.is_regular_file()) continue;
      files[fs::relative(entry.path(), path(folder)).string()] = textOf(entry.path().string());
    }
    return files;
  }

  static std::unique_ptr<TemporaryFolder> here_;
  static ProgramResult preprocessed_, toured_, played_;
};

std::unique_ptr<TemporaryFolder> WholeJob::here_;
ProgramResult WholeJob::preprocessed_, WholeJob::toured_, WholeJob::played_;

TEST_F(WholeJob, EveryStepSucceeds) {
  EXPECT_EQ(preprocessed_.status, 0) << preprocessed_.errors;
  EXPECT_EQ(toured_.status, 0) << toured_.errors;
  EXPECT_EQ(played_.status, 0) << played_.errors;
}

TEST_F(WholeJob, PreprocessingSaysItsStagesOnStderrAndItsResultOnStdout) {
  EXPECT_NE(preprocessed_.errors.find("voxelise"), std::string::npos) << preprocessed_.errors;
  EXPECT_EQ(preprocessed_.errors.find('\r'), std::string::npos) << "a bar without a terminal";
  EXPECT_TRUE(preprocessed_.output.starts_with("house: ")) << preprocessed_.output;
}

TEST_F(WholeJob, InspectDescribesTheHouseAsJson) {
  const ProgramResult result = run({"inspect", "house", "--json", "--plan", "plan.svg", "-q"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const Json json = Json::parse(result.output);
  EXPECT_EQ(json["kind"], "house");
  ASSERT_EQ(json["cells"].size(), 3u);
  EXPECT_NEAR(json["cells"][1]["volume_m3"].get<double>(), 4 * 4 * 2.6, 6);
  ASSERT_GE(json["portals"].size(), 1u);
  EXPECT_NEAR(json["portals"][0]["width_m"].get<double>(), 1.0, 0.15);
  EXPECT_NEAR(json["portals"][0]["height_m"].get<double>(), 2.1, 0.15);
  EXPECT_EQ(json["model"]["name"], "model.glb");
  EXPECT_EQ(json["portal_images"]["textures"], 5 * json["image_sides"].get<int>());
  EXPECT_EQ(json["portal_images"]["references"], 6 * json["image_sides"].get<int>());
  EXPECT_EQ(json["portal_images"]["ldis"], json["image_sides"]);
  EXPECT_EQ(json["parameters"]["bake"], "texture,warp,ldi");
  EXPECT_EQ(json["parameters"]["textures_per_portal"], "5");
  const std::string plan = textOf(path("plan.svg"));
  EXPECT_TRUE(plan.starts_with("<svg")) << plan.substr(0, 100);
  for (std::size_t cell = 1; cell < 3; ++cell) {
    EXPECT_NE(plan.find("<title>" + std::to_string(cell) + " "), std::string::npos) << cell;
  }
}

TEST_F(WholeJob, AHousesOwnGraphGivesTheSameHouse) {
  const ProgramResult result =
      run({"preprocess", "model.glb", "-o", "again", "--no-images", "--graph", "house/house.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(textOf(path("again/cells.grid")), textOf(path("house/cells.grid")));
  const Json before = Json::parse(textOf(path("house/house.json")));
  const Json after = Json::parse(textOf(path("again/house.json")));
  for (const char* part : {"storeys", "cells", "portals"}) EXPECT_EQ(after[part], before[part]);
  EXPECT_EQ(after["parameters"]["cells"], "given");
  EXPECT_EQ(result.errors.find("note: "), std::string::npos) << result.errors;
}

TEST_F(WholeJob, InspectWritesLayersAndCountsTheirSamples) {
  const ProgramResult result = run({"inspect", "house", "--json", "--layers", "layers", "-q"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const Json layers = Json::parse(result.output)["layers"];
  std::size_t most = 0, all = 0, deepest = 0;
  for (const Json& side : layers["sides"]) {
    const auto samples = side["samples"].get<std::size_t>();
    if (samples > most) deepest = side["per_layer"].size();
    most = std::max(most, samples);
    all += samples;
  }
  EXPECT_EQ(layers["all"]["samples"], all);
  EXPECT_EQ(bytesBelow("layers").size(), deepest);
  EXPECT_TRUE(fs::exists(path("layers/layer-1.png")));
  const ProgramResult text =
      run({"inspect", "house", "--layers", "one", "--portal", "0", "--side", "back"});
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_NE(text.errors.find("of portal 0 as seen from its back"), std::string::npos);
  EXPECT_NE(text.output.find("\n  all "), std::string::npos) << text.output;
  EXPECT_NE(text.output.find("captures = ring:3\n"), std::string::npos) << text.output;
}

TEST_F(WholeJob, RaysMakeImagesToo) {
  const Arguments job = {"preprocess",    "model.glb", "--ldi",      "raycast",
                         "--image-size",  "24",        "--captures", "ring:3",
                         "--sight-lines", "5000",      "-q"};
  Arguments one = job, two = job;
  one.insert(one.end(), {"-o", "rays", "-j", "1"});
  two.insert(two.end(), {"-o", "rays-2", "-j", "2"});
  ASSERT_EQ(run(one).status, 0);
  ASSERT_EQ(run(two).status, 0);
  EXPECT_EQ(bytesBelow("rays"), bytesBelow("rays-2"));
  ASSERT_EQ(run({"play", "rays", "--tour", "tour.json", "--methods", "ldi", "--size", "80x64",
                 "--quality", "-q", "-o", "report-rays"})
                .status,
            0);
  const Json summary = Json::parse(textOf(path("report-rays/summary.json")));
  EXPECT_GT(summary["methods"]["ldi"]["psnr_db"]["mean"], 20);
}

TEST_F(WholeJob, TheTourHasItsFramesAndTumHoldsTheSamePoses) {
  const CameraPath tour = readCameraPath(path("tour.json"));
  EXPECT_EQ(tour.poses.size(), 12u);
  ASSERT_EQ(run({"tour", "house", "-o", "t.txt", "--frames", "12", "--format", "tum", "-q"}).status,
            0);
  const CameraPath tum = readCameraPath(path("t.txt"));
  ASSERT_EQ(tum.poses.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(glm::length(tum.poses[i].pose.position - tour.poses[i].pose.position), 0, 1e-4);
  }
}

TEST_F(WholeJob, TheTourIsInTheFormatThatItsFileIsNamedAfter) {
  for (const char* name : {"t.tum", "t.gltf", "t.glb"}) {
    ASSERT_EQ(run({"tour", "house", "-o", name, "--frames", "12", "-q"}).status, 0) << name;
    EXPECT_EQ(readCameraPath(path(name)).poses.size(), 12u) << name;
  }
  EXPECT_TRUE(textOf(path("t.tum")).starts_with("#"));
  EXPECT_TRUE(textOf(path("t.gltf")).starts_with("{"));
  EXPECT_TRUE(textOf(path("t.glb")).starts_with("glTF"));
}

TEST_F(WholeJob, TheReportIsWhole) {
  EXPECT_EQ(bytesBelow("report").size(), 4u + 7u * 12u);
  const std::string csv = textOf(path("report/frames.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 7 * 12);
  const Json summary = Json::parse(textOf(path("report/summary.json")));
  EXPECT_EQ(summary["frames"], 12);
  EXPECT_EQ(summary["size"], (Json{80, 64}));
  EXPECT_EQ(summary["threads"], 2);
  EXPECT_EQ(summary["methods"].size(), 7u);
  EXPECT_EQ(summary["methods"]["culling"]["differing_percent"]["max"], 0);
  EXPECT_GT(summary["methods"]["ldi"]["psnr_db"]["mean"], 20);
  EXPECT_GT(summary["methods"]["ldi"]["portals_as_images"]["max"], 0)
      << "no portal ever showed its image: the walk is too short to tell";
  EXPECT_TRUE(summary["ratios"].contains("culling/ldi"));
  EXPECT_EQ(summary["methods"]["culling"]["flicker"]["max"], 0);
  EXPECT_TRUE(summary["methods"]["ldi"].contains("flicker"));
  EXPECT_GT(summary["methods"]["ldi"]["psnr_portals_db"]["mean"], 20);
  EXPECT_LE(summary["methods"]["ldi"]["psnr_portals_db"]["min"],
            summary["methods"]["ldi"]["psnr_db"]["min"]);
  EXPECT_TRUE(summary["methods"]["ldi"]["switch_jump"]["count"].is_number_unsigned());
  const Image sheet = readImage(path("report/contact-sheet.png"));
  EXPECT_EQ((sheet.width + kSheetGap) % (80 + kSheetGap), 0);
  EXPECT_EQ((sheet.width + kSheetGap) / (80 + kSheetGap), 6)
      << "geometry, texture, warp, warp2, ldi, difference";
  const std::string page = textOf(path("report/report.html"));
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page.find("\"frames_dir\":\"../frames\""), std::string::npos);
}

TEST_F(WholeJob, StdoutEndsWithATableAndWhereTheReportIs) {
  EXPECT_TRUE(played_.output.ends_with("report: report/report.html\n")) << played_.output;
  for (const char* method :
       {"\ngeometry ", "\nraycast ", "\nculling ", "\ntexture ", "\nwarp ", "\nwarp2 ", "\nldi "}) {
    EXPECT_NE(played_.output.find(method), std::string::npos) << played_.output;
  }
}

TEST_F(WholeJob, EveryFrameIsKept) {
  EXPECT_EQ(bytesBelow("frames").size(), 7u * 12u);
  EXPECT_TRUE(fs::exists(path("frames/ldi/frame-00011.png")));
}

TEST_F(WholeJob, ThePicturesOfTheReportAreItsFrames) {
  const Image frame = readImage(path("frames/ldi/frame-00007.png"));
  const Image picture = readImage(path("report/pictures/ldi/00007.jpg"));
  ASSERT_EQ(glm::ivec2(picture.width, picture.height), glm::ivec2(80, 64)) << "not made larger";
  EXPECT_GT(psnr(picture, frame), 25);
}

TEST_F(WholeJob, TheSamePixelsWithOneThreadAsWithTwo) {
  const ProgramResult result =
      run({"play", "house", "--tour", "tour.json", "--methods", kAllMethods, "--size", "80x64",
           "--frames-dir", "frames-1", "--threads", "1", "-q", "-o", "report-1"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(bytesBelow("frames"), bytesBelow("frames-1"));
}

TEST_F(WholeJob, TheSameHouseWithOneThreadAsWithTwo) {
  const ProgramResult result =
      run({"preprocess", "model.glb", "-o", "house-1", "--image-size", "32", "--captures", "ring:3",
           "--bake", "texture,warp,ldi", "--textures-per-portal", "5", "--sight-lines", "5000",
           "-j", "1"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto files = bytesBelow("house"), again = bytesBelow("house-1");
  ASSERT_EQ(files.size(), again.size());
  for (const auto& [name, bytes] : files) {
    EXPECT_TRUE(again.contains(name) && again.at(name) == bytes) << name;
  }
}

TEST_F(WholeJob, ImagesOnDemandNeedNoneOfTheHouseAndAreTheSameEveryTime) {
  ASSERT_EQ(run({"preprocess", "model.glb", "-o", "bare", "--image-size", "32", "--no-images",
                 "--sight-lines", "5000", "-q"})
                .status,
            0);
  for (const char* frames : {"made", "made-again"}) {
    const ProgramResult result =
        run({"play", "bare", "--tour", "tour.json", "--methods", "culling,texture,warp,warp2,ldi",
             "--images", "on-demand", "--size", "80x64", "--frames-dir", frames, "-q", "-o",
             "report-made"});
    ASSERT_EQ(result.status, 0) << result.errors;
  }
  EXPECT_EQ(bytesBelow("made"), bytesBelow("made-again"));
  const Json methods = Json::parse(textOf(path("report-made/summary.json")))["methods"];
  for (const char* method : {"texture", "warp", "warp2", "ldi"}) {
    EXPECT_GT(methods[method]["portals_as_images"]["max"], 0) << method;
    EXPECT_GT(methods[method]["capture_ms"]["max"], 0) << method;
  }
  EXPECT_FALSE(methods["culling"].contains("capture_ms"));
}

TEST_F(WholeJob, WithALimitOnMemoryTheSameEveryTimeAndWithoutRoomItIsCulling) {
  const auto play = [&](const std::string& mib, const char* threads, const std::string& frames) {
    const ProgramResult result =
        run({"play", "house", "--tour", "tour.json", "--methods", "culling,texture,warp2,ldi",
             "--memory", mib, "--size", "80x64", "--threads", threads, "--quality", "--frames-dir",
             frames, "-q", "-o", "report-" + frames});
    EXPECT_EQ(result.status, 0) << result.errors;
    return bytesBelow(frames);
  };
  const auto limited = play("1", "2", "limited");
  EXPECT_EQ(play("1", "1", "limited-1"), limited);
  const auto none = play("0", "2", "none");
  for (const char* method : {"texture", "warp2", "ldi"}) {
    const std::string last = std::string(method) + "/frame-00011.png";
    EXPECT_EQ(none.at(last), none.at("culling/frame-00011.png")) << method;
    EXPECT_EQ(limited.at(last), textOf(path("frames/" + last))) << "once it is all there";
  }
  const Json methods = Json::parse(textOf(path("report-limited/summary.json")))["methods"];
  EXPECT_GT(methods["ldi"]["image_bytes"]["max"], 0);
  EXPECT_LE(methods["ldi"]["image_bytes"]["max"], 1 << 20);
  EXPECT_EQ(methods["ldi"]["portals_lacking_image"]["max"], 0) << "there before the first frame";
  EXPECT_TRUE(methods["ldi"].contains("load_ms"));
  EXPECT_FALSE(methods["culling"].contains("load_ms"));
  const Json without = Json::parse(textOf(path("report-none/summary.json")));
  EXPECT_EQ(without["methods"]["ldi"]["portals_as_images"]["max"], 0);
  EXPECT_GT(without["methods"]["ldi"]["portals_lacking_image"]["max"], 0);
  EXPECT_EQ(without["parameters"]["memory"], "0 MiB");
}

TEST_F(WholeJob, ALimitOnMemorySaysWhatItIsTooSmallForAndWhatItIsNotFor) {
  const Arguments play = {"play",   "house", "--tour",   "tour.json", "--methods", "ldi",
                          "--size", "32x32", "--memory", "0.001",     "-o",        "report-small"};
  const ProgramResult small = run(play);
  EXPECT_EQ(small.status, 0) << small.errors;
  EXPECT_NE(small.errors.find("always show geometry: their images are larger than --memory"),
            std::string::npos)
      << small.errors;
  Arguments on_demand = play;
  on_demand.insert(on_demand.end(), {"--images", "on-demand"});
  const ProgramResult wrong = run(on_demand);
  EXPECT_EQ(wrong.status, 1);
  EXPECT_TRUE(wrong.errors.starts_with("enfilade: --memory: ")) << wrong.errors;
}

TEST_F(WholeJob, ABrokenOrMissingImageIsNamed) {
  fs::copy(path("house"), path("broken"), fs::copy_options::recursive);
  const std::string images = "broken/images/portal-0000-front/";
  const auto complaint = [&](const char* methods) {
    const ProgramResult result =
        run({"play", "broken", "--methods", methods, "-q", "-o", "report-broken"});
    EXPECT_EQ(result.status, 2);
    return result.errors;
  };
  const std::string reference = path(images + "reference-03.bin");
  const std::string whole = textOf(reference);
  writeText(reference, whole.substr(0, whole.size() / 2));
  EXPECT_NE(complaint("culling,warp").find("reference-03.bin: is cut short"), std::string::npos);
  const ProgramResult limited = run({"play", "broken", "--methods", "warp", "--memory", "100",
                                     "--size", "32x32", "-q", "-o", "report-broken"});
  EXPECT_EQ(limited.status, 2);
  EXPECT_TRUE(limited.errors.starts_with("enfilade: broken/images/portal-0000-front/reference-03"))
      << limited.errors;
  EXPECT_EQ(std::count(limited.errors.begin(), limited.errors.end(), '\n'), 1) << limited.errors;
  fs::remove(path(images + "texture-02.png"));
  EXPECT_NE(complaint("texture").find("texture-02.png: is missing"), std::string::npos);
  writeText(path(images + "texture-02.png"), whole);  // another image of the house
  EXPECT_NE(complaint("texture").find("texture-02.png: is cut short, damaged, or of another"),
            std::string::npos);
  EXPECT_EQ(run({"play", "broken", "--tour", "tour.json", "--methods", "ldi", "--size", "32x32",
                 "-q", "-o", "report-broken"})
                .status,
            0)
      << "what is not needed is not read";
}

TEST_F(WholeJob, AReportIsReplacedByTheNext) {
  const Arguments play = {"play",    "house",  "--tour", "tour.json",  "--methods",
                          "culling", "--size", "32x32",  "--pictures", "5",
                          "-q",      "-o",     "twice"};
  ASSERT_EQ(run(play).status, 0);
  writeText(path("twice/note"), "of the first");
  ASSERT_EQ(run(play).status, 0);
  EXPECT_EQ(textOf(path("twice/note")), "of the first") << "it is a person's";
  fs::remove(path("twice/note"));
  EXPECT_EQ(bytesBelow("twice").size(), 3u + 4u) << "of every third frame a picture";
}

TEST_F(WholeJob, TwoReportsAreComparedFrameByFrame) {
  const Arguments play = {"play",        "house",  "--tour", "tour.json", "--methods",
                          "culling,ldi", "--size", "80x64",  "-q",        "--splat",
                          "2x2",         "-o",     "other"};
  ASSERT_EQ(run(play).status, 0);
  const ProgramResult text = run({"report", "report", "other", "-o", "compare.html"});
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_NE(text.output.find("\nA and B differ in splat: mean and 2x2\n"), std::string::npos);
  EXPECT_EQ(text.output, run({"report", "report", "other"}).output) << "the same every time";
  EXPECT_TRUE(textOf(path("compare.html")).starts_with("<!DOCTYPE html>"));
  const Json json = Json::parse(run({"report", "report", "other", "--json"}).output);
  EXPECT_EQ(json["methods"]["ldi"]["changes"][0]["paired_frames"], 12);
  EXPECT_TRUE(json["methods"]["raycast"]["changes"][0].is_null());
  EXPECT_EQ(json["differences"], (Json{"A and B differ in splat: mean and 2x2"}));
}

TEST_F(WholeJob, LogsForOtherViewersAreAFileARunAndMethod) {
  ASSERT_EQ(run({"report", "report", "--mangohud", "logs", "--presentmon", "captures"}).status, 0);
  const auto logs = bytesBelow("logs");
  EXPECT_EQ(logs.size(), 7u);
  EXPECT_EQ(bytesBelow("captures").size(), 7u);
  const std::string& log = logs.at("report-warp2.csv");
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 3 + 12);
}

TEST_F(WholeJob, WithoutATourTheHousesOwnIsPlayed) {
  const ProgramResult result = run({"play", "house", "--methods", "culling", "--size", "32x32",
                                    "--warm-up", "0", "-q", "-o", "own"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(Json::parse(textOf(path("own/summary.json")))["frames"], 520);
}

TEST_F(WholeJob, TheSampleIsRaisedAtTheSizeAskedFor) {
  ASSERT_EQ(run({"sample", "gallery", "-o", "gallery.glb", "--triangles", "50000"}).status, 0);
  const ProgramResult result = run({"inspect", "gallery.glb", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const Json json = Json::parse(result.output);
  EXPECT_EQ(json["kind"], "model");
  EXPECT_NEAR(json["building"]["triangles"].get<double>(), 50000, 10000);
  EXPECT_GT(json["building"]["rooms_named"], 5);
}

TEST_F(WholeJob, HelpAndVersionAreResults) {
  for (const char* command : {"sample", "inspect", "preprocess", "tour", "play", "report"}) {
    const ProgramResult help = run({command, "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.errors, "");
    EXPECT_NE(help.output.find("Example:\n  enfilade " + std::string(command)), std::string::npos);
  }
  EXPECT_EQ(run({"--version"}).output, "enfilade 0.1.0\n");
}

TEST_F(WholeJob, FramesWithinTheReportsFolderAreKeptInEveryRun) {
  for (const char* method : {"culling", "geometry"}) {
    const ProgramResult result =
        run({"play", "house", "--tour", "tour.json", "--methods", method, "--size", "32x32",
             "--frames-dir", "inside/frames", "-q", "-o", "inside"});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_TRUE(fs::exists(path("inside/frames/" + std::string(method) + "/frame-00011.png")));
    EXPECT_TRUE(fs::exists(path("inside/report.html")));
  }
  EXPECT_FALSE(fs::exists(path("inside/frames/culling"))) << "of the report before";
}

}  // namespace
}  // namespace enfilade
