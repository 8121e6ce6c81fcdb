#include "app/comparison_json.h"
#include "app/methods.h"
#include "app/report_assets.h"
#include "app/web_page.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kCharted[] = {"frametime_ms", "triangles", "psnr_db", "psnr_portals_db",
                                    "uncovered_percent"};

Json columnOf(const std::vector<std::optional<double>>& values) {
  Json list = Json::array();
  for (const std::optional<double>& value : values) list.push_back(value ? Json(*value) : Json());
  return list;
}

/// By method the numbers of its frames and what is charted of them.
Json seriesOf(const RecordedRun& run) {
  Json series = Json::object();
  for (const RecordedMethod& method : run.methods) {
    Json& columns = series[method.name];
    columns["frame"] = method.frames;
    for (const char* name : kCharted) {
      const auto column = method.columns.find(name);
      if (column != method.columns.end()) columns[name] = columnOf(column->second);
    }
  }
  return series;
}

/// What the program knows of the methods; a table may name others.
Json descriptions() {
  Json texts = Json::object();
  for (const MethodInfo& info : allMethods()) texts[info.name] = info.description;
  return texts;
}

}  // namespace

std::string comparisonHtml(const Comparison& comparison) {
  Json data = comparisonObject(comparison);
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    data["runs"][i]["series"] = seriesOf(comparison.runs[i]);
  }
  data["descriptions"] = descriptions();
  return assembledPage(
      kComparisonPage,
      {kPageScript, kChartsScript, kDistributionScript, kPrintingScript, kComparisonScript}, data,
      comparisonText(comparison));
}

}  // namespace enfilade
