#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/comparison.h"
#include "app/console.h"
#include "app/frame_logs.h"
#include "app/help_format.h"
#include "app/output_guard.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace {

constexpr std::size_t kMostRuns = 26;  // letters

struct ReportOptions {
  std::vector<std::string> folders;
  std::string output;
  bool json = false;
  std::string mangohud, presentmon;  ///< folders for logs; empty: none
};

/// Writes every run's methods as FOLDER/RUN-METHOD.csv: viewers take the file's name for a label.
void writeLogs(const Comparison& comparison, const std::string& folder,
               std::string (*log)(const RecordedRun&, const RecordedMethod&)) {
  createFolders(folder);
  for (const RecordedRun& run : comparison.runs) {
    std::string name = run.name;
    std::replace(name.begin(), name.end(), '/', '-');
    for (const RecordedMethod& method : run.methods) {
      std::string file = fmt::format("{}-{}.csv", name, method.name);
      std::replace(file.begin(), file.end(), '/', '-');
      writeFileAtomically(folder + "/" + file, log(run, method));
    }
  }
}

void refuse(const ReportOptions& options) {
  if (options.folders.size() > kMostRuns) {
    throw Error(ErrorKind::kUsage, "", fmt::format("at most {} reports are compared", kMostRuns));
  }
  if (!options.output.empty() && options.folders.size() < 2) {
    throw Error(ErrorKind::kUsage, "--output " + options.output,
                "the page compares two reports or more; one report has its report.html");
  }
  for (const std::string& folder : options.folders) refuseToReplace(options.output, folder);
  std::error_code ignored;
  if (std::filesystem::is_directory(options.output, ignored)) {
    throw Error(ErrorKind::kUsage, "--output " + options.output,
                "is a folder; name the page to write, such as compare.html");
  }
}

void runReport(const ReportOptions& options) {
  refuse(options);
  std::vector<RecordedRun> runs;
  for (const std::string& folder : options.folders) runs.push_back(readReport(folder));
  const Comparison comparison = compareRuns(std::move(runs));
  if (!options.output.empty()) writeFileAtomically(options.output, comparisonHtml(comparison));
  if (!options.mangohud.empty()) writeLogs(comparison, options.mangohud, mangoHudLog);
  if (!options.presentmon.empty()) writeLogs(comparison, options.presentmon, presentMonLog);
  printResult(options.json ? comparisonJson(comparison) : comparisonText(comparison));
}

}  // namespace

void addReportCommand(CLI::App& program, CommandContext& context) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = addCommand(program, "report", "Compare what 'enfilade play' reported of runs",
                                 "enfilade report before after -o compare.html", context.quiet);
  command
      ->add_option("REPORT", options->folders,
                   "Folders that 'enfilade play' wrote; each is set against the first, frame by "
                   "frame where they are the same walk. Of one its table is printed")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Write a page that shows the runs side by side and opens offline")
      ->type_name("FILE.html")
      ->check(notEmpty());
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command
      ->add_option("--mangohud", options->mangohud,
                   "Write the frame times as logs of MangoHud, FOLDER/REPORT-METHOD.csv, for "
                   "mangoplot, FlightlessMango and the like")
      ->type_name("FOLDER")
      ->check(notEmpty())
      ->group("Logs for other viewers");
  command
      ->add_option("--presentmon", options->presentmon,
                   "Write them as captures of PresentMon, for CapFrameX and the like")
      ->type_name("FOLDER")
      ->check(notEmpty())
      ->group("Logs for other viewers");
  command->callback([options, &context] { context.run = [options] { runReport(*options); }; });
}

}  // namespace enfilade
