#include "app/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace enfilade {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::string part;
  for (const char c : text) {
    if (c == at) {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  return parts;
}

/// Geometry takes 10, 20 and 30 ms, ldi 4, 5 and 9; the doorway 6 switches in frame 1, and back.
Report exampleReport() {
  Report report;
  report.house = "house";
  report.command = "enfilade play house";
  report.width = 640;
  report.height = 512;
  report.threads = 2;
  report.frames = 3;
  report.methods = {Method::kGeometry, Method::kLdi};
  const double geometry_ms[] = {10, 20, 30};
  const double ldi_ms[] = {4, 5, 9};
  for (std::size_t frame = 0; frame < 3; ++frame) {
    FrameRecord record{Method::kGeometry, frame, {}, ImageQuality{}};
    record.cost.frametime_ms = geometry_ms[frame];
    record.cost.cull_ms = 0.5;
    record.cost.draw_ms = geometry_ms[frame] - 0.5;
    record.cost.triangles = 1000 * (frame + 1);
    if (frame > 0) record.flicker = 0.0;
    report.records.push_back(record);
  }
  for (std::size_t frame = 0; frame < 3; ++frame) {
    FrameRecord record{
        Method::kLdi, frame, {}, ImageQuality{30.0 + static_cast<double>(frame), 0.9, 12}};
    record.cost = {ldi_ms[frame], 0.1,  std::nullopt, 2,  0.3, 1, 50, 2, 3, 1,
                   4000,          1000, 0.25,         {}, {},  {}};
    if (frame > 0) {  // the first shows no image
      record.quality->psnr_portals_db = 24.0 + static_cast<double>(frame);
      record.quality->ssim_portals = 0.85;
      record.flicker = 0.25 * static_cast<double>(frame);
    }
    report.records.push_back(record);
  }
  report.findings.jumps = {{Method::kLdi, 1, {{6, true}, true}, 100, 4.0, 28.0},
                           {Method::kLdi, 2, {{6, true}, false}, 90, 5.0, 27.0}};
  return report;
}

/// With a sheet of two rows of geometry, ldi and the difference, of 4 × 3 pixels each.
Report reportWithSheet() {
  Report report = exampleReport();
  ContactSheet& sheet = report.findings.sheet.emplace();
  sheet.methods = {Method::kGeometry, Method::kLdi};
  sheet.rows = {{2, {100, 27.5}}, {0, {100, 30.25}}};
  sheet.cell = {4, 3};
  sheet.picture.width = 3 * 4 + 2 * kSheetGap;
  sheet.picture.height = 2 * 3 + kSheetGap;
  return report;
}

TEST(FramesCsv, HasTheColumnsOfTheDesignInTheirOrder) {
  const std::string csv = framesCsv(exampleReport());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "method,frame,frametime_ms,cull_ms,warp_ms,composite_ms,draw_ms,triangles,cells,"
            "portals,portals_as_images,samples,samples_clipped,psnr_db,ssim,differing_percent,"
            "uncovered_percent,psnr_portals_db,ssim_portals,flicker,capture_ms,load_ms,portals_"
            "lacking_image,"
            "image_bytes");
}

TEST(FramesCsv, IsARowAFrameAndMethodWithEmptyCellsForWhatThereIsNot) {
  const std::vector<std::string> lines = split(framesCsv(exampleReport()), '\n');
  ASSERT_EQ(lines.size(), 8u);  // head, six rows, and what follows the last line's end
  EXPECT_EQ(
      lines[2],
      "geometry,1,20.0000,0.5000,,,19.5000,2000,,,,,,100.000,1.000000,0.00000,,,,0.00000,,,,");
  EXPECT_EQ(lines[6],
            "ldi,2,9.0000,0.1000,2.0000,0.3000,1.0000,50,2,3,1,4000,1000,32.000,"
            "0.900000,12.00000,0.25000,26.000,0.850000,0.50000,,,,");
  EXPECT_TRUE(lines[4].ends_with(",12.00000,0.25000,,,,,,,")) << lines[4];
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(split(lines[i], ',').size(), 24u) << lines[i];
  EXPECT_EQ(lines[7], "");
}

TEST(SummaryJson, HoldsWhatTheDesignNames) {
  const Json json = Json::parse(summaryJson(exampleReport()));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["size"], (Json{640, 512}));
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["frames"], 3);
  EXPECT_TRUE(json["machine"].is_object());
  const Json& ldi = json["methods"]["ldi"];
  const Json frame_ms{{"mean", 6.0}, {"p50", 5.0}, {"p95", 8.6}, {"p99", 8.92}, {"max", 9.0}};
  EXPECT_EQ(ldi["frame_ms"], frame_ms);
  EXPECT_EQ(ldi["psnr_db"], (Json{{"mean", 31.0}, {"p5", 30.1}, {"min", 30.0}}));
  EXPECT_EQ(ldi["uncovered_percent"], (Json{{"mean", 0.25}, {"p95", 0.25}, {"max", 0.25}}));
  EXPECT_TRUE(ldi.contains("warp_ms"));
  EXPECT_TRUE(ldi.contains("triangles"));
}

TEST(SummaryJson, HoldsQualityInPortalsAndFlicker) {
  const Json json = Json::parse(summaryJson(exampleReport()));
  const Json& ldi = json["methods"]["ldi"];
  EXPECT_EQ(ldi["psnr_portals_db"], (Json{{"mean", 25.5}, {"p5", 25.05}, {"min", 25.0}}));
  EXPECT_EQ(ldi["ssim_portals"]["mean"], 0.85);
  EXPECT_EQ(ldi["flicker"]["mean"], 0.375);
  EXPECT_EQ(ldi["flicker"]["max"], 0.5);
  EXPECT_EQ(json["methods"]["geometry"]["flicker"]["max"], 0);
  EXPECT_FALSE(json["methods"]["geometry"].contains("psnr_portals_db"));
}

TEST(SummaryJson, TellsTheJumpsAtSwitches) {
  Report report = exampleReport();
  const Json json = Json::parse(summaryJson(report));
  EXPECT_EQ(json["methods"]["ldi"]["switch_jump"],
            (Json{{"count", 2},
                  {"levels", {{"p50", 4.5}, {"max", 5.0}}},
                  {"psnr_db", {{"p50", 27.5}, {"min", 27.0}}},
                  {"worst", {{"frame", 2}, {"portal", 6}, {"from_front", true}}}}));
  EXPECT_FALSE(json["methods"]["geometry"].contains("switch_jump"));
  report.findings.jumps.clear();
  EXPECT_EQ(Json::parse(summaryJson(report))["methods"]["ldi"]["switch_jump"],
            (Json{{"count", 0}}));
  for (FrameRecord& record : report.records) record.quality.reset();
  EXPECT_FALSE(Json::parse(summaryJson(report))["methods"]["ldi"].contains("switch_jump"));
}

TEST(SummaryJson, LeavesOutWhatAMethodDoesNotHave) {
  const Json json = Json::parse(summaryJson(exampleReport()));
  const Json& geometry = json["methods"]["geometry"];
  EXPECT_FALSE(geometry.contains("warp_ms"));
  EXPECT_FALSE(geometry.contains("uncovered_percent"));
  EXPECT_TRUE(geometry.contains("ssim"));
}

TEST(SummaryJson, RatiosAreOfMedianFrames) {
  const Json json = Json::parse(summaryJson(exampleReport()));
  EXPECT_EQ(json["ratios"], (Json{{"geometry/ldi", 4.0}}));
}

TEST(ReportHtml, NeedsNothingFromElsewhereAndHoldsTheData) {
  const std::string page = reportHtml(exampleReport());
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("<link"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  for (const char* mark : {"/*DATA*/", "/*SCRIPT*/", "/*STYLE*/", "/*CHART LIBRARY*/"}) {
    EXPECT_EQ(page.find(mark), std::string::npos) << mark;
  }
  EXPECT_NE(page.find("\"frametime_ms\":[10.0,20.0,30.0]"), std::string::npos);
}

TEST(ReportHtml, AFrameWithoutAValueIsAGapInTheSeries) {
  const std::string page = reportHtml(exampleReport());
  EXPECT_NE(page.find("\"psnr_portals_db\":[null,25.0,26.0]"), std::string::npos);
  EXPECT_NE(page.find("\"flicker\":[null,0.25,0.5]"), std::string::npos);
}

TEST(ReportHtml, SaysWhereThePicturesOfTheContactSheetLie) {
  const std::string page = reportHtml(reportWithSheet());
  EXPECT_NE(page.find("\"sheet\":{\"file\":\"contact-sheet.png\",\"size\":[28,14],\"cell\":[4,3],"
                      "\"gap\":8,\"amplification\":4,\"columns\":[\"geometry\",\"ldi\"],\"rows\":"
                      "[{\"frame\":2,\"psnr_db\":[100.0,27.5]},{\"frame\":0,"),
            std::string::npos);
  EXPECT_NE(reportHtml(exampleReport()).find("\"sheet\":null"), std::string::npos);
}

TEST(ReportHtml, ANameCannotEndTheScript) {
  Report report = exampleReport();
  report.house = "</script><script>alert(1)</script>";
  const std::string page = reportHtml(report);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>\\u003cscript>alert"), std::string::npos);
}

TEST(ReportHtml, HoldsThePlanAndWhereEachFrameStandsOnIt) {
  Report report = exampleReport();
  EXPECT_NE(reportHtml(report).find("\"plan\":null"), std::string::npos);
  report.plan.size = {480, 300};
  report.plan.scale = 20;
  report.plan.storeys = {{"ground", 0, "<path class=\"wall\"/>"}, {"first", 3, ""}};
  report.plan.steps = {{{10, 20}, 90, 0}, {{11.26f, 20}, 0, 0}, {{12, 20}, -90, 1}};
  const std::string page = reportHtml(report);
  EXPECT_NE(page.find("\"name\":\"ground\",\"floor_y\":0.0,\"drawing\":\"\\u003cpath"),
            std::string::npos);
  EXPECT_NE(page.find("\"x\":[10.0,11.3,12.0]"), std::string::npos);
  EXPECT_NE(page.find("\"heading\":[90.0,0.0,-90.0],\"storey\":[0,0,1]"), std::string::npos);
}

TEST(ReportHtml, SaysWhereThePicturesLieOrThatThereAreNone) {
  Report report = exampleReport();
  EXPECT_NE(reportHtml(report).find("\"pictures\":null"), std::string::npos);
  report.picture_stride = 4;
  EXPECT_NE(reportHtml(report).find("\"pictures\":{\"folder\":\"pictures\",\"stride\":4}"),
            std::string::npos);
}

TEST(ReportHtml, TellsAReaderWithoutScriptsTheTable) {
  const std::string page = reportHtml(exampleReport());
  const std::size_t start = page.rfind("<noscript>");
  ASSERT_NE(start, std::string::npos);
  const std::string words = page.substr(start, page.find("</noscript>", start) - start);
  EXPECT_NE(words.find("\ngeometry      20.00"), std::string::npos) << words;
  EXPECT_NE(words.find("\nldi            5.00"), std::string::npos) << words;
}

TEST(SummaryJson, HoldsTheParametersOfPlayingAndOfTheHouse) {
  Report report = exampleReport();
  report.parameters = {{"splat", "mean"}, {"warm-up", "3"}};
  report.house_parameters = {{"voxel_m", "0.1"}};
  report.house_version = "0.0.9";
  const Json json = Json::parse(summaryJson(report));
  EXPECT_EQ(json["parameters"], (Json{{"splat", "mean"}, {"warm-up", "3"}}));
  EXPECT_EQ(json["house"]["parameters"], (Json{{"voxel_m", "0.1"}}));
  EXPECT_EQ(json["house"]["tool_version"], "0.0.9");
}

TEST(ReportTable, IsALineAMethodWithTheSpeedUpOverGeometry) {
  const std::vector<std::string> lines = split(reportTable(exampleReport()), '\n');
  ASSERT_GE(lines.size(), 3u);
  EXPECT_EQ(lines[1],
            "geometry      20.00     29.00        2000     1.00   100.00          -           -");
  EXPECT_EQ(lines[2],
            "ldi            5.00      8.60          50     4.00    31.00      25.50       0.250");
}

}  // namespace
}  // namespace enfilade
