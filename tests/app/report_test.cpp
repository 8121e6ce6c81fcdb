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

/// Geometry takes 10, 20 and 30 ms, ldi 4, 5 and 9.
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
    report.records.push_back(record);
  }
  for (std::size_t frame = 0; frame < 3; ++frame) {
    FrameRecord record{
        Method::kLdi, frame, {}, ImageQuality{30.0 + static_cast<double>(frame), 0.9, 12}};
    record.cost = {ldi_ms[frame], 0.1, 2, 0.3, 1, 50, 2, 3, 1, 4000, 1000, 0.25};
    report.records.push_back(record);
  }
  return report;
}

TEST(FramesCsv, HasTheColumnsOfTheDesignInTheirOrder) {
  const std::string csv = framesCsv(exampleReport());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "method,frame,frametime_ms,cull_ms,warp_ms,composite_ms,draw_ms,triangles,cells,"
            "portals,portals_as_images,samples,samples_clipped,psnr_db,ssim,differing_percent,"
            "uncovered_percent,capture_ms");
}

TEST(FramesCsv, IsARowAFrameAndMethodWithEmptyCellsForWhatThereIsNot) {
  const std::vector<std::string> lines = split(framesCsv(exampleReport()), '\n');
  ASSERT_EQ(lines.size(), 8u);  // head, six rows, and what follows the last line's end
  EXPECT_EQ(lines[2], "geometry,1,20.0000,0.5000,,,19.5000,2000,,,,,,100.000,1.000000,0.00000,,");
  EXPECT_EQ(lines[6],
            "ldi,2,9.0000,0.1000,2.0000,0.3000,1.0000,50,2,3,1,4000,1000,32.000,"
            "0.900000,12.00000,0.25000,");
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(split(lines[i], ',').size(), 18u) << lines[i];
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

TEST(ReportHtml, ANameCannotEndTheScript) {
  Report report = exampleReport();
  report.house = "</script><script>alert(1)</script>";
  const std::string page = reportHtml(report);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>\\u003cscript>alert"), std::string::npos);
}

TEST(ReportTable, IsALineAMethodWithTheSpeedUpOverGeometry) {
  const std::vector<std::string> lines = split(reportTable(exampleReport()), '\n');
  ASSERT_GE(lines.size(), 3u);
  EXPECT_EQ(lines[1], "geometry      20.00     29.00        2000     1.00   100.00           -");
  EXPECT_EQ(lines[2], "ldi            5.00      8.60          50     4.00    31.00       0.250");
}

}  // namespace
}  // namespace enfilade
