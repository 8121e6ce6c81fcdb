#include "app/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/frame_logs.h"
#include "app/statistics.h"

namespace enfilade {
namespace {

using Json = nlohmann::ordered_json;

RecordedMethod methodOf(const std::string& name, const std::vector<double>& ms) {
  RecordedMethod method{name, {}, {}};
  for (std::size_t f = 0; f < ms.size(); ++f) {
    method.frames.push_back(f);
    method.columns["frametime_ms"].emplace_back(ms[f]);
  }
  return method;
}

/// Frame times that rise and fall along the walk, `scale` times as long, some at random longer.
std::vector<double> walkMs(double scale, unsigned salt = 0, double noise = 0.05) {
  std::vector<double> ms;
  unsigned state = 12345 + salt;
  for (int f = 0; f < 200; ++f) {
    state = state * 1664525u + 1013904223u;
    const double random = static_cast<double>(state >> 8) / (1 << 24);
    ms.push_back(scale * (5 + 3 * std::sin(0.1 * f)) * (1 + noise * (random - 0.5)));
  }
  return ms;
}

RecordedRun runOf(const std::string& folder, const std::vector<RecordedMethod>& methods) {
  RecordedRun run;
  run.folder = folder;
  run.name = folder.substr(folder.rfind('/') + 1);
  run.methods = methods;
  run.frame_count = methods.front().frames.size();
  run.tour_sha256 = "a";
  run.facts = {{"tour", "tour.json", "a", true}, {"size", "640 x 512", "640 x 512", true}};
  return run;
}

TEST(PairedRatio, OfARunWithItselfIsOne) {
  const RecordedMethod method = methodOf("ldi", walkMs(1));
  const PairedRatio ratio = pairedRatio(method, method).value();
  EXPECT_EQ(ratio.frames, 200u);
  for (const double value : {ratio.median, ratio.p5, ratio.p95, ratio.least, ratio.greatest}) {
    EXPECT_DOUBLE_EQ(value, 1);
  }
  EXPECT_STREQ(verdictOf(ratio), "no difference");
}

TEST(PairedRatio, FindsAKnownFactorThroughNoiseFarSmallerThanTheWalksOwnSwing) {
  const RecordedMethod a = methodOf("ldi", walkMs(1, 1)), b = methodOf("ldi", walkMs(0.97, 2));
  const PairedRatio ratio = pairedRatio(a, b).value();
  EXPECT_NEAR(ratio.median, 0.97, 0.005);
  EXPECT_LE(ratio.p5, ratio.least);
  EXPECT_LE(ratio.least, ratio.median);
  EXPECT_LE(ratio.median, ratio.greatest);
  EXPECT_LE(ratio.greatest, ratio.p95);
  EXPECT_STREQ(verdictOf(ratio), "faster");
  EXPECT_STREQ(verdictOf(pairedRatio(b, a).value()), "slower");
}

TEST(PairedRatio, IsOfTheFramesThatBothHave) {
  RecordedMethod a = methodOf("ldi", {1, 2, 3, 4}), b = methodOf("ldi", {10, 20, 30});
  b.frames = {1, 3, 9};
  const PairedRatio ratio = pairedRatio(a, b).value();
  EXPECT_EQ(ratio.frames, 2u);
  EXPECT_DOUBLE_EQ(ratio.median, 5);  // 10/2 and 20/4
  b.frames = {7, 8, 9};
  EXPECT_FALSE(pairedRatio(a, b));
}

TEST(MedianInterval, IsTheSameEveryTimeAndHoldsTheMedian) {
  const std::vector<double> values = walkMs(1);
  const auto [least, greatest] = medianInterval(values);
  EXPECT_EQ(medianInterval(values), std::make_pair(least, greatest));
  EXPECT_LT(least, percentile(values, 50));
  EXPECT_GT(greatest, percentile(values, 50));
  const std::vector<double> one = {7};
  EXPECT_EQ(medianInterval(one), std::make_pair(7.0, 7.0));
}

TEST(MedianInterval, IsWiderWhereNeighboursAreAlike) {
  std::vector<double> alike, mixed;
  for (int i = 0; i < 400; ++i) {
    alike.push_back(std::sin(0.05 * i));
    mixed.push_back(std::sin(0.05 * (i * 167 % 400)));  // the same values in another order
  }
  const auto [a, b] = medianInterval(alike);
  const auto [c, d] = medianInterval(mixed);
  EXPECT_GT(b - a, 2 * (d - c));
}

TEST(MedianInterval, HoldsTheTrueMedianAsOftenAsItSays) {
  int held = 0;
  for (unsigned trial = 0; trial < 100; ++trial) {
    std::vector<double> values;
    unsigned state = 77 * trial + 5;
    for (int i = 0; i < 150; ++i) {
      state = state * 1664525u + 1013904223u;
      values.push_back(static_cast<double>(state >> 8) / (1 << 24));
    }
    const auto [least, greatest] = medianInterval(values);
    held += least <= 0.5 && 0.5 <= greatest;
  }
  EXPECT_GE(held, 85);
}

TEST(Comparison, SaysWhatMakesRunsIncomparableAndWhatElseDiffers) {
  RecordedRun a = runOf("a", {methodOf("ldi", walkMs(1))}), b = a;
  b.folder = b.name = "b";
  a.facts.push_back({"splat", "mean", "mean", false});
  b.facts.push_back({"splat", "2x2", "2x2", false});
  EXPECT_TRUE(compareRuns({a, b}).incomparable.empty());
  EXPECT_EQ(compareRuns({a, b}).differences,
            std::vector<std::string>{"A and B differ in splat: mean and 2x2"});
  b.facts[1] = {"size", "320 x 256", "320 x 256", true};
  EXPECT_EQ(compareRuns({a, b}).incomparable,
            std::vector<std::string>{"A and B differ in size: 640 x 512 and 320 x 256"});
  b.facts[0].identity = "another";
  EXPECT_EQ(compareRuns({a, b}).incomparable.at(0),
            "A and B differ in tour: two that are both called tour.json");
  b.facts[0].identity = "";
  EXPECT_EQ(compareRuns({a, b}).incomparable.size(), 1u)
      << "what is not known is not held against it";
}

TEST(Comparison, PairsFramesOfTheSameWalkAlone) {
  const RecordedRun a = runOf("a", {methodOf("ldi", walkMs(1))});
  RecordedRun b = runOf("b", {methodOf("ldi", walkMs(2))});
  EXPECT_NEAR(compareRuns({a, b}).methods[0].changes[0].paired.value().median, 2, 0.01);
  b.tour_sha256 = "another";
  const MethodChange change = compareRuns({a, b}).methods[0].changes[0];
  EXPECT_FALSE(change.paired);
  EXPECT_NEAR(change.of_medians.value(), 2, 0.01);
}

TEST(Comparison, AMethodThatOneRunLacksHasNoRatio) {
  const RecordedRun a = runOf("a", {methodOf("culling", walkMs(1))});
  const RecordedRun b = runOf("b", {methodOf("culling", walkMs(1)), methodOf("ldi", walkMs(1))});
  const Comparison comparison = compareRuns({a, b});
  ASSERT_EQ(comparison.methods.size(), 2u);
  EXPECT_EQ(comparison.methods[1].name, "ldi");
  EXPECT_FALSE(comparison.methods[1].changes[0].of_medians);
  const Json json = Json::parse(comparisonJson(comparison));
  EXPECT_TRUE(json["methods"]["ldi"]["runs"][0].is_null());
  EXPECT_TRUE(json["methods"]["ldi"]["changes"][0].is_null());
  EXPECT_EQ(json["methods"]["culling"]["changes"][0]["verdict"], "no difference");
}

TEST(Comparison, RunsOfOneNameAreToldApartByTheirFolders) {
  const RecordedMethod method = methodOf("ldi", walkMs(1));
  const Comparison comparison =
      compareRuns({runOf("x/report", {method}), runOf("y/report", {method}), runOf("z", {method})});
  EXPECT_EQ(comparison.runs[0].name, "x/report");
  EXPECT_EQ(comparison.runs[1].name, "y/report");
  EXPECT_EQ(comparison.runs[2].name, "z");
}

TEST(ComparisonText, HasARowForEveryMethodAndRun) {
  const RecordedRun a = runOf("a", {methodOf("ldi", walkMs(1))});
  const std::string text =
      comparisonText(compareRuns({a, runOf("b", {methodOf("ldi", walkMs(2))})}));
  EXPECT_NE(text.find("\nldi       A  "), std::string::npos) << text;
  EXPECT_NE(text.find("  slower\n"), std::string::npos) << text;
  EXPECT_EQ(comparisonText(compareRuns({a})).find("ratio"), std::string::npos);
}

TEST(ComparisonHtml, NeedsNothingFromElsewhereAndNamesCannotEndTheScript) {
  RecordedRun a = runOf("</script><script>alert(1)", {methodOf("<b>", walkMs(1))});
  const std::string page = comparisonHtml(compareRuns({a, a}));
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<b>\""), std::string::npos);
  for (const char* elsewhere : {"src=\"http", "<link", "@import", "/*DATA*/", "<!--WORDS-->"}) {
    EXPECT_EQ(page.find(elsewhere), std::string::npos) << elsewhere;
  }
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(FrameLogs, OfMangoHudHaveItsHeadsAndCountNanosecondsFromTheStart) {
  RecordedRun run = runOf("a", {methodOf("ldi", {4, 6})});
  run.machine = {"CPU, fast", 2, 1 << 20, "Debian (bookworm), Linux 6.1.0", "llvmpipe (15, 256)"};
  const std::vector<std::string> lines = linesOf(mangoHudLog(run, run.methods[0]));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "os,cpu,gpu,ram,kernel,driver,cpuscheduler");
  EXPECT_EQ(lines[1],
            "Debian (bookworm),CPU  fast,llvmpipe (15  256),1024,Linux 6.1.0,enfilade ldi,");
  EXPECT_TRUE(lines[2].starts_with("fps,frametime,cpu_load,"));
  EXPECT_TRUE(lines[2].ends_with(",elapsed"));
  EXPECT_TRUE(lines[4].starts_with("166.6667,6.0000,0,")) << lines[4];
  EXPECT_TRUE(lines[4].ends_with(",10000000")) << lines[4];
  for (std::size_t i = 3; i < 5; ++i) {
    EXPECT_EQ(std::count(lines[i].begin(), lines[i].end(), ','),
              std::count(lines[2].begin(), lines[2].end(), ','));
  }
}

TEST(FrameLogs, OfPresentMonBeginWithTheApplicationAndCountSeconds) {
  const RecordedRun run = runOf("a", {methodOf("ldi", {4, 6})});
  const std::vector<std::string> lines = linesOf(presentMonLog(run, run.methods[0]));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(lines[0].starts_with("Application,ProcessID,"));
  EXPECT_EQ(lines[2],
            "enfilade-ldi.exe,0,0x0,Other,0,0,0,0.0100000,0,6.0000,0,Other,6.0000,6.0000,6.0000");
  EXPECT_EQ(std::count(lines[0].begin(), lines[0].end(), ','),
            std::count(lines[2].begin(), lines[2].end(), ','));
}

}  // namespace
}  // namespace enfilade
