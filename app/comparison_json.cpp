#include "app/comparison_json.h"

#include <cmath>

#include "app/statistics.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

double toMillionth(double value) { return std::round(value * 1e6) / 1e6; }

Json runObject(const RecordedRun& run, std::size_t index) {
  Json facts = Json::object();
  for (const RunFact& fact : run.facts) facts[fact.what] = fact.value;
  return {{"run", letterOf(index)}, {"name", run.name}, {"folder", run.folder}, {"facts", facts}};
}

/// Of a method's columns what both tables say; null where a run lacks the method.
Json figuresObject(const RecordedMethod* method) {
  if (method == nullptr) return nullptr;
  const Summary s = summarise(method->values("frametime_ms"));
  Json json{{"frames", method->frames.size()},
            {"frame_ms",
             {{"mean", toMillionth(s.mean)},
              {"p50", toMillionth(s.p50)},
              {"p95", toMillionth(s.p95)},
              {"p99", toMillionth(s.p99)},
              {"max", toMillionth(s.max)}}}};
  for (const char* column : {"triangles", "psnr_db", "psnr_portals_db", "uncovered_percent"}) {
    const std::vector<double> values = method->values(column);
    if (!values.empty()) json[column] = {{"mean", toMillionth(summarise(values).mean)}};
  }
  return json;
}

Json changeObject(const MethodChange& change) {
  if (!change.of_medians) return nullptr;
  Json json{{"ratio_of_medians", toMillionth(*change.of_medians)}};
  if (!change.paired) return json;
  const PairedRatio& p = *change.paired;
  json["paired_frames"] = p.frames;
  json["ratio"] = {{"median", toMillionth(p.median)},
                   {"p5", toMillionth(p.p5)},
                   {"p95", toMillionth(p.p95)},
                   {"median_interval_95", {toMillionth(p.least), toMillionth(p.greatest)}}};
  json["verdict"] = verdictOf(p);
  return json;
}

}  // namespace

Json comparisonObject(const Comparison& comparison) {
  Json json{{"schema", 1}, {"runs", Json::array()}};
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    json["runs"].push_back(runObject(comparison.runs[i], i));
  }
  json["comparable"] = comparison.incomparable.empty();
  json["incomparable"] = comparison.incomparable;
  json["differences"] = comparison.differences;
  json["methods"] = Json::object();
  for (const MethodComparison& method : comparison.methods) {
    Json& object = json["methods"][method.name];
    object = {{"runs", Json::array()}, {"changes", Json::array()}};
    for (const RecordedRun& run : comparison.runs) {
      object["runs"].push_back(figuresObject(run.method(method.name)));
    }
    for (const MethodChange& change : method.changes) {
      object["changes"].push_back(changeObject(change));
    }
  }
  return json;
}

std::string comparisonJson(const Comparison& comparison) {
  return comparisonObject(comparison).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace enfilade
