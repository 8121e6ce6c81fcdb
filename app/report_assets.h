#pragma once

#include <string_view>

namespace enfilade {

/// Files that the build puts into the program (cmake/EmbedFile.cmake).
extern const std::string_view kReportPage;      ///< app/report/report.html
extern const std::string_view kComparisonPage;  ///< app/report/comparison.html
extern const std::string_view kReportStyle;     ///< app/report/report.css
/// The pages' scripts, app/report/*.js.
extern const std::string_view kPageScript, kTablesScript, kChartsScript, kDistributionScript,
    kPicturesScript, kPlanScript, kAboutScript, kPrintingScript, kReportScript, kComparisonScript;
/// The chart library dygraphs (Debian's libjs-dygraphs, MIT); empty if it was not there when the
/// program was built: the page then has its tables alone.
extern const std::string_view kChartLibrary;
extern const std::string_view kChartStyle;

}  // namespace enfilade
