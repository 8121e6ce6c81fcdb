#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "app/report.h"

namespace enfilade {

namespace {

/// The median of one method's column; nothing if it has no values.
std::optional<double> statistic(const Report& report, Method method, const std::string& column,
                                double Summary::*figure) {
  const std::vector<double> values = columnValues(report, method, columnNamed(column));
  if (values.empty()) return std::nullopt;
  return summarise(values).*figure;
}

std::string cell(const std::optional<double>& value, int decimals, int width) {
  if (!value) return fmt::format("{:>{}}", "-", width);
  return fmt::format("{:>{}.{}f}", *value, width, decimals);
}

}  // namespace

std::vector<double> columnValues(const Report& report, Method method, const FrameColumn& column) {
  std::vector<double> values;
  for (const FrameRecord& record : report.records) {
    if (record.method != method) continue;
    if (const std::optional<double> value = column.value(record)) values.push_back(*value);
  }
  return values;
}

const FrameColumn& columnNamed(const std::string& name) {
  const std::span<const FrameColumn> columns = frameColumns();
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const FrameColumn& c) { return name == c.name; });
  assert(found != columns.end());
  return *found;
}

std::optional<JumpSummary> jumpsOf(const Report& report, Method method) {
  if (!infoOf(method).portal_images) return std::nullopt;
  if (columnValues(report, method, columnNamed("psnr_db")).empty()) return std::nullopt;
  std::vector<double> levels, psnr_db;
  SwitchJump worst;
  for (const SwitchJump& jump : report.findings.jumps) {
    if (jump.method != method) continue;
    levels.push_back(jump.levels);
    psnr_db.push_back(jump.psnr_db);
    if (levels.size() == 1 || jump.levels > worst.levels) worst = jump;
  }
  return JumpSummary{levels.size(), summarise(levels), summarise(psnr_db), worst};
}

std::vector<std::pair<std::string, double>> frameTimeRatios(const Report& report) {
  std::vector<std::pair<std::string, double>> ratios;
  for (auto a = report.methods.begin(); a != report.methods.end(); ++a) {
    for (auto b = a + 1; b != report.methods.end(); ++b) {
      const auto slow = statistic(report, *a, "frametime_ms", &Summary::p50);
      const auto fast = statistic(report, *b, "frametime_ms", &Summary::p50);
      if (!slow || !fast || *fast <= 0) continue;
      ratios.emplace_back(fmt::format("{}/{}", infoOf(*a).name, infoOf(*b).name), *slow / *fast);
    }
  }
  return ratios;
}

std::string framesCsv(const Report& report) {
  std::string csv = "method,frame";
  for (const FrameColumn& column : frameColumns()) csv += std::string(",") + column.name;
  csv += '\n';
  for (const FrameRecord& record : report.records) {
    csv += fmt::format("{},{}", infoOf(record.method).name, record.frame);
    for (const FrameColumn& column : frameColumns()) {
      const std::optional<double> value = column.value(record);
      csv += value ? fmt::format(",{:.{}f}", *value, column.decimals) : std::string(",");
    }
    csv += '\n';
  }
  return csv;
}

std::string reportTable(const Report& report) {
  const bool has_geometry = std::find(report.methods.begin(), report.methods.end(),
                                      Method::kGeometry) != report.methods.end();
  const auto reference = has_geometry
                             ? statistic(report, Method::kGeometry, "frametime_ms", &Summary::p50)
                             : std::nullopt;
  std::string table =
      fmt::format("{:<9} {:>9} {:>9} {:>11} {:>8} {:>8} {:>10} {:>11}\n", "method", "median ms",
                  "p95 ms", "triangles", "speed-up", "PSNR dB", "in portals", "uncovered %");
  for (const Method method : report.methods) {
    const auto median = statistic(report, method, "frametime_ms", &Summary::p50);
    std::optional<double> speed_up;
    if (reference && median && *median > 0) speed_up = *reference / *median;
    table += fmt::format(
        "{:<9} {} {} {} {} {} {} {}\n", infoOf(method).name, cell(median, 2, 9),
        cell(statistic(report, method, "frametime_ms", &Summary::p95), 2, 9),
        cell(statistic(report, method, "triangles", &Summary::mean), 0, 11), cell(speed_up, 2, 8),
        cell(statistic(report, method, "psnr_db", &Summary::mean), 2, 8),
        cell(statistic(report, method, "psnr_portals_db", &Summary::mean), 2, 10),
        cell(statistic(report, method, "uncovered_percent", &Summary::mean), 3, 11));
  }
  table += has_geometry ? "speed-up: median frame of geometry over that of the method; " : "";
  table +=
      "triangles, PSNR (of the frame, and in the portals' images alone) and uncovered are means\n";
  return table;
}

}  // namespace enfilade
