#pragma once

#include <string_view>

namespace enfilade {

/// Files that the build puts into the program (cmake/EmbedFile.cmake).
extern const std::string_view kReportPage;   ///< app/report/report.html
extern const std::string_view kReportStyle;  ///< app/report/report.css
/// The scripts of a run's page, app/report/*.js, in the order in which they must run.
extern const std::string_view kPageScript, kTablesScript, kChartsScript, kDistributionScript,
    kPicturesScript, kPlanScript, kAboutScript, kPrintingScript, kReportScript;
/// The chart library dygraphs (Debian's libjs-dygraphs, MIT); empty if it was not there when the
/// program was built: the page then has its tables alone.
extern const std::string_view kChartLibrary;
extern const std::string_view kChartStyle;

}  // namespace enfilade
