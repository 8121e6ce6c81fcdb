#include "app/report_json.h"

#include <cmath>

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

/// Six significant digits: more is noise, and reads badly.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const double scale = std::pow(10.0, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

/// The figures that matter of a column: of quality its mean and its bad tail.
Json summaryOf(const FrameColumn& column, const std::vector<double>& values) {
  const Summary s = summarise(values);
  const std::string name = column.name;
  Json json{{"mean", rounded(s.mean)}};
  if (column.tail == FrameColumn::Tail::kLow) {
    json["p5"] = rounded(s.p5);
    json["min"] = rounded(s.min);
    return json;
  }
  const bool share = name.ends_with("_percent");
  if (!share) json["p50"] = rounded(s.p50);
  json["p95"] = rounded(s.p95);
  if (!share) json["p99"] = rounded(s.p99);
  json["max"] = rounded(s.max);
  return json;
}

/// How far the picture jumps at the switches between image and geometry.
Json jumpObject(const JumpSummary& jumps) {
  Json json{{"count", jumps.count}};
  if (jumps.count == 0) return json;
  json["levels"] = {{"p50", rounded(jumps.levels.p50)}, {"max", rounded(jumps.levels.max)}};
  json["psnr_db"] = {{"p50", rounded(jumps.psnr_db.p50)}, {"min", rounded(jumps.psnr_db.min)}};
  json["worst"] = {{"frame", jumps.worst.frame},
                   {"portal", jumps.worst.event.side.portal},
                   {"from_front", jumps.worst.event.side.from_front}};
  return json;
}

Json methodObject(const Report& report, Method method) {
  Json json = Json::object();
  for (const FrameColumn& column : frameColumns()) {
    const std::vector<double> values = columnValues(report, method, column);
    if (!values.empty()) json[column.summary_name] = summaryOf(column, values);
  }
  if (const auto jumps = jumpsOf(report, method)) json["switch_jump"] = jumpObject(*jumps);
  return json;
}

Json machineObject(const MachineInfo& machine) {
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"memory_bytes", machine.memory_bytes},
          {"system", machine.system},
          {"gl_renderer", machine.gl_renderer}};
}

Json houseObject(const Report& report) {
  Json json{{"folder", report.house},
            {"model", report.model},
            {"model_sha256", report.model_sha256},
            {"cells", report.cells},
            {"portals", report.portals},
            {"triangles", report.triangles},
            {"images", report.images},
            {"tool_version", report.house_version}};
  json["parameters"] = Json::object();
  for (const auto& [name, value] : report.house_parameters) json["parameters"][name] = value;
  return json;
}

}  // namespace

Json summaryObject(const Report& report) {
  Json json;
  json["schema"] = 1;
  json["house"] = houseObject(report);
  json["size"] = {report.width, report.height};
  json["threads"] = report.threads;
  json["frames"] = report.frames;
  json["machine"] = machineObject(report.machine);
  json["tool_version"] = report.tool_version;
  json["command"] = report.command;
  json["tour"] = report.tour;
  json["tour_sha256"] = report.tour_sha256;
  json["vertical_fov_degrees"] = rounded(report.vertical_fov_degrees);
  json["parameters"] = Json::object();
  for (const auto& [name, value] : report.parameters) json["parameters"][name] = value;
  json["percentiles"] = "linear between the closest ranks";
  json["methods"] = Json::object();
  for (const Method method : report.methods) {
    json["methods"][infoOf(method).name] = methodObject(report, method);
  }
  json["ratios"] = Json::object();
  for (const auto& [name, ratio] : frameTimeRatios(report)) json["ratios"][name] = rounded(ratio);
  return json;
}

std::string summaryJson(const Report& report) {
  return summaryObject(report).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace enfilade
