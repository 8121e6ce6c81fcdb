#include <cmath>

#include "app/report.h"
#include "app/report_assets.h"
#include "app/report_json.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

/// Every frame's values by method and column: what the page draws.
Json seriesObject(const Report& report) {
  Json series = Json::object();
  for (const Method method : report.methods) {
    Json& columns = series[infoOf(method).name];
    columns = Json::object();
    for (const FrameColumn& column : frameColumns()) {
      const std::vector<double> values = columnValues(report, method, column);
      if (values.empty()) continue;
      const double scale = std::pow(10.0, column.decimals);
      Json& list = columns[column.name];
      for (const double value : values) list.push_back(std::round(value * scale) / scale);
    }
  }
  return series;
}

/// JSON that may stand inside a script element: nothing in it can end the element.
std::string forScript(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

void replaceOnce(std::string& text, const std::string& mark, std::string_view by) {
  const std::size_t at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), by);
}

}  // namespace

std::string reportHtml(const Report& report) {
  Json descriptions = Json::object();
  for (const Method method : report.methods) {
    descriptions[infoOf(method).name] = infoOf(method).description;
  }
  const Json data = {{"summary", summaryObject(report)},
                     {"series", seriesObject(report)},
                     {"descriptions", descriptions},
                     {"frames_dir", report.frames_dir}};
  std::string page(kReportPage);
  // The data last: what a person named must not be taken for a mark.
  replaceOnce(page, "/*CHART STYLE*/", kChartStyle);
  replaceOnce(page, "/*STYLE*/", kReportStyle);
  replaceOnce(page, "/*CHART LIBRARY*/", kChartLibrary);
  replaceOnce(page, "/*SCRIPT*/", kReportScript);
  replaceOnce(page, "/*DATA*/", forScript(data));
  return page;
}

}  // namespace enfilade
