#include <algorithm>

#include "app/methods.h"
#include "app/report_reader.h"
#include "app/user_settings.h"
#include "tests/fuzz/soundness.h"
#include "tests/fuzz/targets.h"

namespace enfilade::fuzz {

void report(Bytes input) {
  const Bytes summary = takePart(input);
  const RecordedRun run = decodeReport(textOf(summary), textOf(input), "/reports/before");
  require(!run.methods.empty(), "a report has methods");
  requireOneLine(run.line());
  for (const RunFact& fact : run.facts) requireOneLine(fact.what);
  for (const RecordedMethod& method : run.methods) {
    requireOneLine(method.name);
    for (const auto& [name, values] : method.columns) {
      require(values.size() == method.frames.size(), "a value a frame");
    }
  }
}

void settings(Bytes input) {
  const auto& [read, note] = decodeViewSettings(input, "view.json");
  if (!note.empty()) requireOneLine(note);
  require(read.width >= 160 && read.width <= 16384 && read.height >= 120 && read.height <= 16384,
          "a size within its limits");
  require(read.fov_degrees >= 20 && read.fov_degrees <= 120, "a field of view within its limits");
  require(read.speed >= 0.1f && read.speed <= 20, "a speed within its limits");
  const auto methods = allMethods();
  require(std::any_of(methods.begin(), methods.end(),
                      [&](const MethodInfo& info) { return info.name == read.method; }),
          "a method that there is");
}

}  // namespace enfilade::fuzz
