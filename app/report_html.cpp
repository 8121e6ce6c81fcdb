#include <cmath>

#include "app/report.h"
#include "app/report_assets.h"
#include "app/report_json.h"
#include "app/web_page.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

/// A column's value of every frame, null where there is none.
Json seriesOf(const Report& report, Method method, const FrameColumn& column) {
  const double scale = std::pow(10.0, column.decimals);
  Json list = Json::array();
  for (const FrameRecord& record : report.records) {
    if (record.method != method) continue;
    const std::optional<double> value = column.value(record);
    list.push_back(value ? Json(std::round(*value * scale) / scale) : Json());
  }
  return list;
}

/// Every frame's values by method and column: what the page draws.
Json seriesObject(const Report& report) {
  Json series = Json::object();
  for (const Method method : report.methods) {
    Json& columns = series[infoOf(method).name];
    columns = Json::object();
    for (const FrameColumn& column : frameColumns()) {
      if (columnValues(report, method, column).empty()) continue;
      columns[column.name] = seriesOf(report, method, column);
    }
  }
  return series;
}

/// Where each picture of the contact sheet lies in it, and what it shows; null without a sheet.
Json sheetObject(const Report& report) {
  if (!report.findings.sheet) return {};
  const ContactSheet& sheet = *report.findings.sheet;
  Json columns = Json::array(), rows = Json::array();
  for (const Method method : sheet.methods) columns.push_back(infoOf(method).name);
  for (const ContactSheet::Row& row : sheet.rows) {
    rows.push_back({{"frame", row.frame}, {"psnr_db", row.psnr_db}});
  }
  return {{"file", kContactSheetFile},
          {"size", {sheet.picture.width, sheet.picture.height}},
          {"cell", {sheet.cell.x, sheet.cell.y}},
          {"gap", kSheetGap},
          {"amplification", kSheetAmplification},
          {"columns", columns},
          {"rows", rows}};
}

/// Where small pictures of frames lie beside the page; null if none were kept.
Json picturesObject(const Report& report) {
  if (report.picture_stride == 0) return nullptr;
  return {{"folder", kPicturesFolder}, {"stride", report.picture_stride}};
}

double toTenth(float pixels) { return std::round(static_cast<double>(pixels) * 10) / 10; }

/// The plan's storeys, and where each frame stands on them; null without a plan.
Json planObject(const ReportPlan& plan) {
  if (plan.storeys.empty()) return nullptr;
  Json storeys = Json::array(), x = Json::array(), y = Json::array(), heading = Json::array(),
       storey = Json::array();
  for (const ReportPlan::Storey& level : plan.storeys) {
    storeys.push_back(
        {{"name", level.name}, {"floor_y", toTenth(level.floor_y)}, {"drawing", level.drawing}});
  }
  for (const ReportPlan::Step& step : plan.steps) {
    x.push_back(toTenth(step.place.x));
    y.push_back(toTenth(step.place.y));
    heading.push_back(toTenth(step.heading));
    storey.push_back(step.storey);
  }
  return {{"size", {toTenth(plan.size.x), toTenth(plan.size.y)}},
          {"scale", toTenth(plan.scale)},
          {"storeys", storeys},
          {"x", x},
          {"y", y},
          {"heading", heading},
          {"storey", storey}};
}

}  // namespace

std::string reportHtml(const Report& report) {
  Json descriptions = Json::object();
  for (const Method method : report.methods) {
    descriptions[infoOf(method).name] = infoOf(method).description;
  }
  const Json data = {{"summary", summaryObject(report)}, {"series", seriesObject(report)},
                     {"descriptions", descriptions},     {"sheet", sheetObject(report)},
                     {"plan", planObject(report.plan)},  {"pictures", picturesObject(report)},
                     {"frames_dir", report.frames_dir}};
  return assembledPage(kReportPage,
                       {kPageScript, kTablesScript, kChartsScript, kDistributionScript,
                        kPicturesScript, kPlanScript, kAboutScript, kPrintingScript, kReportScript},
                       data, reportTable(report));
}

}  // namespace enfilade
