#include "app/preprocess_run.h"

#include <filesystem>

#include "app/console.h"
#include "app/interruption.h"
#include "app/program.h"
#include "app/progress.h"
#include "app/stop_deadline.h"
#include "preprocess/bake_images.h"
#include "preprocess/unfinished_house.h"

namespace enfilade {

namespace {

/// After this the work is ended wherever it is: nothing under its name is ever half written.
constexpr std::chrono::milliseconds kPatience{1000};

void sayWhatIsKept(const std::string& output) {
  const std::string kept = describeUnfinished(output);
  printError("stopped: " +
             (kept.empty() ? "nothing was finished yet, and nothing is kept" : kept + kHowToGoOn));
}

/// Before the program is ended in its tracks.
void sayAndTidy(const std::string& output, bool was_there) {
  sayWhatIsKept(output);
  std::error_code ignored;
  if (!was_there) std::filesystem::remove(output, ignored);  // unless something is in it
}

PreprocessResult runTelling(const std::string& model, const std::string& output,
                            const PreprocessParameters& parameters, bool quiet) {
  std::error_code ignored;
  const bool was_there = std::filesystem::exists(output, ignored);
  const StopDeadline deadline(kPatience, [&] { sayAndTidy(output, was_there); });
  ProgressPrinter printer(quiet);
  const ProgressSink sink = printer.sink();
  PreprocessListener listener;
  listener.progress = [&](const std::string& stage, double done) {
    Interruption::throwIfAsked();
    sink(stage, done);
  };
  listener.note = [&](const std::string& line) { printNote(quiet, line); };
  listener.sides = [&](std::size_t, std::size_t all) { printer.countParts(kBakingStage, all); };
  listener.checkpoint = Interruption::throwIfAsked;
  return preprocessBuilding(model, output, parameters, listener);
}

}  // namespace

PreprocessResult runPreprocessing(const std::string& model, const std::string& output,
                                  const PreprocessParameters& parameters, bool quiet) {
  const Interruption interruption;
  try {
    return runTelling(model, output, parameters, quiet);
  } catch (const Interrupted&) {
    sayWhatIsKept(output);
    throw;
  }
}

}  // namespace enfilade
