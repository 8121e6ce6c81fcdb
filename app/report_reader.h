#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/machine_info.h"

namespace enfilade {

/// One method's rows of a frames.csv.
struct RecordedMethod {
  std::string name;
  std::vector<std::size_t> frames;  ///< increasing
  /// By the column's name, a value a frame; columns that are empty throughout are left out.
  std::map<std::string, std::vector<std::optional<double>>> columns;

  /// The values that a column has, in the order of frames; none without it.
  std::vector<double> values(const std::string& column) const;
};

/// Something that a run was made with, by which two runs are told apart.
struct RunFact {
  std::string what;      ///< "size"
  std::string value;     ///< for a person
  std::string identity;  ///< equal in runs that agree; empty: not known
  bool must_agree;       ///< frame times of runs that differ in it cannot be compared
};

/// What `enfilade play` wrote into a report folder.
struct RecordedRun {
  std::string folder;  ///< as it was named
  std::string name;    ///< its last part
  MachineInfo machine;
  std::string tour_sha256;  ///< empty: of a version that did not say
  std::size_t frame_count = 0;
  std::vector<RunFact> facts;
  std::vector<RecordedMethod> methods;  ///< in the order of the file

  const RecordedMethod* method(const std::string& method_name) const;
  /// What a run is summed up by: "640 x 512, 520 frames, 2 threads, enfilade 0.1.0".
  std::string line() const;
};

/// Reads summary.json and frames.csv of a folder.  Throws Error (kBadInput) that names the file
/// and, in a table, the line: missing, too large (64 MiB), another schema, not JSON, a column that
/// is missing, a row of another length, something that is no number, a frame that is there twice.
RecordedRun readReport(const std::string& folder);

/// The same of the texts of the two files in `folder`.
RecordedRun decodeReport(const std::string& summary_json, const std::string& frames_csv,
                         const std::string& folder);

/// The methods in the text of a frames.csv; `file` names it in errors.
std::vector<RecordedMethod> parseFramesCsv(const std::string& text, const std::string& file);

}  // namespace enfilade
