// What a report folder says is read back, and what is broken in one is named with its file and
// line.
#include "app/report_reader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/report.h"
#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

constexpr const char* kHead = "method,frame,frametime_ms,triangles\n";

/// What parsing the text complains of; empty: nothing.
std::string complaintOf(const std::string& csv) {
  try {
    parseFramesCsv(csv, "frames.csv");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    return error.what();
  }
  return "";
}

TEST(FramesCsvReader, RefusesAHeadOfColumnsWithoutEnd) {
  EXPECT_EQ(complaintOf(std::string(1 << 20, ',')),
            "frames.csv: line 1: has more columns than there can be");
}

TEST(FramesCsvReader, ReadsBackWhatTheReportWrote) {
  Report report;
  report.methods = {Method::kGeometry, Method::kLdi};
  for (const Method method : report.methods) {
    for (std::size_t frame = 0; frame < 3; ++frame) {
      FrameRecord record{method, frame, {}};
      record.cost.frametime_ms = 1.5 + static_cast<double>(frame);
      if (method == Method::kLdi && frame > 0) record.cost.warp_ms = 0.25;
      report.records.push_back(record);
    }
  }
  const std::vector<RecordedMethod> methods = parseFramesCsv(framesCsv(report), "frames.csv");
  ASSERT_EQ(methods.size(), 2u);
  EXPECT_EQ(methods[0].name, "geometry");
  EXPECT_EQ(methods[1].frames, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(methods[1].values("frametime_ms"), (std::vector<double>{1.5, 2.5, 3.5}));
  EXPECT_EQ(methods[1].values("warp_ms"), (std::vector<double>{0.25, 0.25}));
  EXPECT_FALSE(methods[1].columns.at("warp_ms")[0]);
  EXPECT_FALSE(methods[0].columns.contains("warp_ms")) << "a column without values is left out";
}

TEST(FramesCsvReader, ReadsWhatASpreadsheetSaved) {
  const std::string csv = "\xef\xbb\xbfmethod,frame,frametime_ms\r\nldi,0,1.5\r\nldi,4,2\r\n";
  const std::vector<RecordedMethod> methods = parseFramesCsv(csv, "frames.csv");
  EXPECT_EQ(methods.at(0).frames, (std::vector<std::size_t>{0, 4}));
}

TEST(FramesCsvReader, NamesTheLineOfABrokenRow) {
  const std::string start = std::string(kHead) + "ldi,0,1.5,10\n";
  const auto expect = [&](const std::string& row, const std::string& reason) {
    EXPECT_EQ(complaintOf(start + row + "\n"), "frames.csv: line 3: " + reason);
  };
  expect("ldi,1,1.5", "has 3 cells, the head has 4");
  expect("ldi,1,1.5,10,11", "has 5 cells, the head has 4");
  expect("", "has 1 cells, the head has 4");
  expect("ldi,1,fast,10", "'fast' in frametime_ms is no number");
  expect("ldi,1,1.5ms,10", "'1.5ms' in frametime_ms is no number");
  expect("ldi,1,nan,10", "'nan' in frametime_ms is no number");
  expect("ldi,1,inf,10", "'inf' in frametime_ms is no number");
  expect("ldi,1,1e999,10", "'1e999' in frametime_ms is no number");
  expect("ldi,1,,10", "'' in frametime_ms is no number");
  expect("ldi,1,0,10", "a frame cannot take 0 ms or less");
  expect("ldi,1,-2,10", "a frame cannot take 0 ms or less");
  expect("ldi,1,1.5,many", "'many' in triangles is no number");
  expect("ldi,one,1.5,10", "'one' is no frame's number");
  expect("ldi,-1,1.5,10", "'-1' is no frame's number");
  expect("ldi,0,1.5,10", "frame 0 of ldi stands after frame 0");
  expect(",1,1.5,10", "names no method");
  expect("l\x1b[2Jdi,1,1.5,10", "has no method's name in its first cell");
  expect("ld\x7f,1,1.5,10", "has no method's name in its first cell");
  expect(std::string(5000, 'm') + ",1,1.5,10", "has no method's name in its first cell");
  expect("ldi,1," + std::string(5000, 'x') + ",10",
         "'" + std::string(40, 'x') + "' in frametime_ms is no number");
}

TEST(FramesCsvReader, RefusesARowAMethod) {
  std::string csv = kHead;
  for (int i = 0; i < 100; ++i) csv += "m" + std::to_string(i) + ",0,1.5,10\n";
  EXPECT_EQ(complaintOf(csv), "frames.csv: line 66: names more methods than there can be");
}

TEST(FramesCsvReader, RefusesATableThatIsNone) {
  EXPECT_EQ(complaintOf(kHead), "frames.csv: has no rows");
  EXPECT_NE(complaintOf("").find("has no column 'method'"), std::string::npos);
  EXPECT_NE(complaintOf("a,b,c\n1,2,3\n").find("has no column 'method'"), std::string::npos);
  EXPECT_NE(complaintOf("method,frame\nldi,0\n").find("has no column 'frametime_ms'"),
            std::string::npos);
  EXPECT_EQ(complaintOf("method,frame,frametime_ms,frame\n"),
            "frames.csv: line 1: has the column 'frame' twice");
}

class ReportReader : public ::testing::Test {
 protected:
  ReportReader() {
    writeText(here_ / "frames.csv", std::string(kHead) + "ldi,0,1.5,10\n");
    writeText(here_ / "summary.json", R"({"schema": 1, "frames": 1, "size": [640, 512]})");
  }

  std::string complaint() const {
    try {
      readReport(here_.path());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      return error.what();
    }
    return "";
  }
  void expectOfSummary(const std::string& summary, const std::string& reason) {
    writeText(here_ / "summary.json", summary);
    EXPECT_EQ(complaint(), here_ / "summary.json" + ": " + reason);
  }

  TemporaryFolder here_;
};

TEST_F(ReportReader, ReadsASummaryThatSaysLittle) {
  const RecordedRun run = readReport(here_.path() + "/");
  EXPECT_EQ(run.name, std::filesystem::path(here_.path()).filename());
  EXPECT_EQ(run.frame_count, 1u);
  EXPECT_EQ(run.methods.size(), 1u);
  EXPECT_TRUE(run.line().starts_with("640 x 512, 1 frames")) << run.line();
}

TEST_F(ReportReader, NamesAFileThatIsMissing) {
  std::filesystem::remove(here_ / "frames.csv");
  EXPECT_EQ(complaint(), here_ / "frames.csv" + ": no such file");
  std::filesystem::remove(here_ / "summary.json");
  EXPECT_EQ(complaint(), here_ / "summary.json" + ": no such file");
}

TEST_F(ReportReader, RefusesASummaryThatIsNone) {
  expectOfSummary("", "is not JSON");
  expectOfSummary("{\"schema\": 1", "is not JSON");
  expectOfSummary("[]", "is no summary of 'enfilade play': it has no schema");
  expectOfSummary("{}", "is no summary of 'enfilade play': it has no schema");
  expectOfSummary(R"({"schema": 2})", "has schema 2; this program reads schema 1");
  expectOfSummary(R"({"schema": "1"})", "has schema \"1\"; this program reads schema 1");
  expectOfSummary(R"({"schema": 1, "frames": "many"})", "has no count at /frames");
  expectOfSummary(R"({"schema": 1, "frames": -1})", "has no count at /frames");
  expectOfSummary(R"({"schema": 1, "machine": {"cpu": []}})", "has no plain value at /machine/cpu");
  expectOfSummary(R"({"schema": 1, "parameters": 7})", "has no object at /parameters");
}

TEST_F(ReportReader, SummariesThatAreDeepOrOfOtherShapesDoNoHarm) {
  writeText(here_ / "summary.json",
            R"({"schema": 1, "size": 640, "machine": "mine", "house": []})");
  EXPECT_EQ(complaint(), "");
  for (const std::string& open : {std::string(), std::string(R"({"schema": )")}) {
    const std::string nested = std::string(200'000, '[') + std::string(200'000, ']');
    expectOfSummary(open + nested + (open.empty() ? "" : "}"), "nests its JSON deeper than 100");
  }
}

TEST_F(ReportReader, RefusesAHugeFileWithoutReadingIt) {
  std::filesystem::resize_file(here_ / "frames.csv", std::uintmax_t{65} << 20);  // sparse
  EXPECT_EQ(complaint(),
            here_ / "frames.csv" + ": is larger than 64 MiB, too large for what it is");
}

}  // namespace
}  // namespace enfilade
