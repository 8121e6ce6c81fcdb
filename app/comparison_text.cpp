#include <fmt/format.h>

#include <algorithm>

#include "app/comparison.h"
#include "app/statistics.h"

namespace enfilade {

namespace {

/// A column of the second table: a mean over a method's frames.
struct Figure {
  const char* head;
  const char* column;
  int decimals;
};

constexpr Figure kFigures[] = {{"triangles", "triangles", 0},
                               {"PSNR dB", "psnr_db", 2},
                               {"in portals", "psnr_portals_db", 2},
                               {"uncovered %", "uncovered_percent", 3}};

std::string cell(const std::optional<double>& value, int decimals, int width) {
  if (!value) return fmt::format("{:>{}}", "-", width);
  return fmt::format("{:>{}.{}f}", *value, width, decimals);
}

std::string range(double low, double high) { return fmt::format("{:.3f} to {:.3f}", low, high); }

std::string timesOf(const RecordedMethod* method) {
  if (method == nullptr) return fmt::format("{:>9} {:>9} {:>9}", "-", "-", "-");
  const Summary s = summarise(method->values("frametime_ms"));
  return fmt::format("{:>9.2f} {:>9.2f} {:>9.2f}", s.p50, s.p95, s.p99);
}

std::string changeText(const MethodChange& change) {
  if (change.paired) {
    const PairedRatio& p = *change.paired;
    return fmt::format(" {:>10.3f}  {:<16}  {:<16}  {}", p.median, range(p.p5, p.p95),
                       range(p.least, p.greatest), verdictOf(p));
  }
  return cell(change.of_medians, 3, 11) + (change.of_medians ? "  ratio of the medians alone" : "");
}

/// Frame times of every method and run, and how each relates to the first run's.
std::string timeTable(const Comparison& comparison) {
  const bool several = comparison.runs.size() > 1;
  std::string table = fmt::format("{:<9} {:<3} {:>9} {:>9} {:>9}", "method", "run", "median ms",
                                  "p95 ms", "p99 ms");
  if (several) {
    table += fmt::format(" {:>10}  {:<16}  {:<16}", "ratio to A", "5th to 95th", "95 % of median") +
             "  in these runs";
  }
  table += '\n';
  for (const MethodComparison& method : comparison.methods) {
    for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
      std::string row = fmt::format("{:<9} {:<3} {}", i == 0 ? method.name : "", letterOf(i),
                                    timesOf(comparison.runs[i].method(method.name)));
      if (i > 0) row += changeText(method.changes[i - 1]);
      table += row + '\n';
    }
  }
  return table;
}

std::string figuresTable(const Comparison& comparison) {
  std::string table = fmt::format("{:<9} {:<3}", "method", "run");
  for (const Figure& figure : kFigures) table += fmt::format(" {:>11}", figure.head);
  table += '\n';
  for (const MethodComparison& method : comparison.methods) {
    for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
      table += fmt::format("{:<9} {:<3}", i == 0 ? method.name : "", letterOf(i));
      const RecordedMethod* recorded = comparison.runs[i].method(method.name);
      for (const Figure& figure : kFigures) {
        const std::vector<double> values =
            recorded ? recorded->values(figure.column) : std::vector<double>();
        table += ' ' + cell(values.empty() ? std::nullopt : std::optional(summarise(values).mean),
                            figure.decimals, 11);
      }
      table += '\n';
    }
  }
  return table;
}

}  // namespace

std::string comparisonText(const Comparison& comparison) {
  std::string text;
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const RecordedRun& run = comparison.runs[i];
    text += fmt::format("{}: {}: {}\n", letterOf(i), run.name, run.line());
  }
  for (const std::string& note : comparison.incomparable) text += "NOT COMPARABLE: " + note + '\n';
  for (const std::string& note : comparison.differences) text += note + '\n';
  text += '\n' + timeTable(comparison) + '\n' + figuresTable(comparison);
  text +=
      "triangles, PSNR (of the frame, and in the portals' images alone) and uncovered are means\n";
  if (comparison.runs.size() < 2) return text;
  return text +
         "ratio to A: the median of the frames' own ratios; 90 % of the frames lie from the 5th to "
         "the "
         "95th\npercentile; the interval of the median speaks of these frames, not of what the "
         "machine "
         "did besides:\nplay the same twice to see how far equal runs lie apart\n";
}

}  // namespace enfilade
