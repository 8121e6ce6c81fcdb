#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/frame_record.h"
#include "app/machine_info.h"
#include "app/quality_pass.h"
#include "app/report_plan.h"
#include "app/statistics.h"

namespace enfilade {

/// All that a report of a playback says.
struct Report {
  std::string tool_version;
  std::string command;  ///< that repeats it
  std::string house;    ///< the folder, as it was named
  std::string model, model_sha256;
  std::string house_version;                            ///< of the program that preprocessed it
  std::map<std::string, std::string> house_parameters;  ///< of preprocessing
  std::string tour;                                     ///< the path's name
  std::string tour_sha256;                              ///< of its poses and doors
  std::size_t cells = 0, portals = 0, triangles = 0, images = 0;
  int width = 0, height = 0;
  double vertical_fov_degrees = 0;
  int threads = 0;
  std::size_t frames = 0;
  std::vector<std::pair<std::string, std::string>>
      parameters;  ///< of playing, as options name them
  std::vector<Method> methods;
  MachineInfo machine;
  std::vector<FrameRecord> records;  ///< method after method, each with all frames
  PictureFindings findings;          ///< with --quality
  std::string frames_dir;  ///< where frames were kept, relative to the report; empty: nowhere
  ReportPlan plan;         ///< the house's, with the path
  std::size_t picture_stride = 0;  ///< of so many frames one is kept small; 0: none is
};

/// Of one method's values in one column; empty where it has none.
std::vector<double> columnValues(const Report& report, Method method, const FrameColumn& column);

/// The column named `name` in frames.csv; there must be one.
const FrameColumn& columnNamed(const std::string& name);

/// Median frame time of each method over that of each later one: "culling/ldi" → 2.1.
std::vector<std::pair<std::string, double>> frameTimeRatios(const Report& report);

/// The jumps of one method at its switches between image and geometry.
struct JumpSummary {
  std::size_t count = 0;
  Summary levels, psnr_db;
  SwitchJump worst;  ///< of the most levels; none if `count` is 0
};

/// Empty: nobody looked, or the method shows no images.
std::optional<JumpSummary> jumpsOf(const Report& report, Method method);

/// Where the contact sheet lies beside report.html.
inline constexpr const char* kContactSheetFile = "contact-sheet.png";

/// frames.csv: a row a frame and method, empty cells where there is nothing to measure.
std::string framesCsv(const Report& report);

/// summary.json (DESIGN, section 6).
std::string summaryJson(const Report& report);

/// report.html: one page that needs nothing else and opens offline.
std::string reportHtml(const Report& report);

/// What playback ends with on stdout: a line a method.
std::string reportTable(const Report& report);

}  // namespace enfilade
