#include "app/report_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/json_depth.h"
#include "scene/printable.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

std::string textOf(const std::string& file) {
  const std::vector<std::uint8_t> bytes = readFile(file, kMostTextBytes);
  return {bytes.begin(), bytes.end()};
}

/// A summary.json, asked for what it says.
class SummaryFile {
 public:
  SummaryFile(const std::string& text, const std::string& file) : file_(file) {
    requireShallowJson(text, file);
    json_ = Json::parse(text, nullptr, false);
    if (json_.is_discarded()) fail("is not JSON");
    if (!json_.is_object() || !json_.contains("schema")) {
      fail("is no summary of 'enfilade play': it has no schema");
    }
    if (json_["schema"] != kSchema) {
      fail(fmt::format("has schema {}; this program reads schema {}",
                       json_["schema"].dump().substr(0, 40), kSchema));
    }
  }

  /// What is at `path`, such as "/machine/cpu", as a person reads it; empty if it is not there.
  std::string text(const std::string& path) const {
    const Json* value = at(path);
    if (value == nullptr || value->is_null()) return {};
    if (value->is_string()) return printable(value->get<std::string>());
    if (value->is_structured()) fail("has no plain value at " + path);
    return value->dump();
  }

  std::uint64_t count(const std::string& path) const {
    const Json* value = at(path);
    if (value == nullptr) return 0;
    if (!value->is_number_unsigned()) fail("has no count at " + path);
    return value->get<std::uint64_t>();
  }

  /// Names and values of an object.
  std::vector<std::pair<std::string, std::string>> texts(const std::string& path) const {
    std::vector<std::pair<std::string, std::string>> all;
    const Json* object = at(path);
    if (object == nullptr) return all;
    if (!object->is_object()) fail("has no object at " + path);
    for (const auto& [key, value] : object->items()) {
      all.emplace_back(printable(key),
                       printable(value.is_string() ? value.get<std::string>() : value.dump()));
    }
    return all;
  }

 private:
  const Json* at(const std::string& path) const {
    const Json::json_pointer pointer(path);
    try {
      return json_.contains(pointer) ? &json_.at(pointer) : nullptr;
    } catch (const Json::exception&) {
      return nullptr;
    }
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, file_, reason);
  }

  std::string file_;
  Json json_;
};

std::vector<RunFact> factsOf(const SummaryFile& summary) {
  std::vector<RunFact> facts;
  const auto add = [&](const std::string& what, const std::string& value, bool must_agree) {
    facts.push_back({what, value, value, must_agree});
  };
  const std::string model = summary.text("/house/model_sha256");
  facts.push_back({"model", summary.text("/house/model"),
                   model.empty() ? summary.text("/house/model") : model, true});
  facts.push_back({"tour", summary.text("/tour"), summary.text("/tour_sha256"), true});
  add("frames", summary.text("/frames"), true);
  add("size", summary.text("/size/0") + " x " + summary.text("/size/1"), true);
  add("field of view", summary.text("/vertical_fov_degrees") + " degrees", true);
  add("threads", summary.text("/threads"), true);
  add("CPU", summary.text("/machine/cpu"), true);
  add("cores", summary.text("/machine/cores"), true);
  add("OpenGL", summary.text("/machine/gl_renderer"), true);
  add("system", summary.text("/machine/system"), false);
  add("version", summary.text("/tool_version"), false);
  for (const auto& [name, value] : summary.texts("/parameters")) add(name, value, false);
  for (const auto& [name, value] : summary.texts("/house/parameters")) {
    add("house's " + name, value, false);
  }
  return facts;
}

std::string summaryFile(const std::string& folder) { return folder + "/summary.json"; }
std::string framesFile(const std::string& folder) { return folder + "/frames.csv"; }

/// The last part of a path that has one.
std::string nameOf(const std::string& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path.filename() : path.parent_path().filename()).string();
}

}  // namespace

std::vector<double> RecordedMethod::values(const std::string& column) const {
  std::vector<double> all;
  const auto found = columns.find(column);
  if (found == columns.end()) return all;
  for (const std::optional<double>& value : found->second) {
    if (value) all.push_back(*value);
  }
  return all;
}

const RecordedMethod* RecordedRun::method(const std::string& method_name) const {
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const RecordedMethod& m) { return m.name == method_name; });
  return found == methods.end() ? nullptr : &*found;
}

std::string RecordedRun::line() const {
  const auto value = [&](const std::string& what) {
    const auto found = std::find_if(facts.begin(), facts.end(),
                                    [&](const RunFact& fact) { return fact.what == what; });
    return found == facts.end() ? std::string() : found->value;
  };
  return fmt::format("{}, {} frames, {} threads, enfilade {}", value("size"), value("frames"),
                     value("threads"), value("version"));
}

RecordedRun decodeReport(const std::string& summary_json, const std::string& frames_csv,
                         const std::string& folder) {
  RecordedRun run;
  run.folder = folder;
  run.name = nameOf(folder);
  const SummaryFile summary(summary_json, summaryFile(folder));
  run.machine = {summary.text("/machine/cpu"), static_cast<int>(summary.count("/machine/cores")),
                 summary.count("/machine/memory_bytes"), summary.text("/machine/system"),
                 summary.text("/machine/gl_renderer")};
  run.tour_sha256 = summary.text("/tour_sha256");
  run.frame_count = summary.count("/frames");
  run.facts = factsOf(summary);
  run.methods = parseFramesCsv(frames_csv, framesFile(folder));
  for (const RecordedMethod& method : run.methods) {
    if (run.frame_count == 0 || method.frames.size() == run.frame_count) continue;
    throw Error(ErrorKind::kBadInput, framesFile(folder),
                fmt::format("has {} frames of {}, and summary.json tells of {}: it is cut short, "
                            "or of another report",
                            method.frames.size(), method.name, run.frame_count));
  }
  return run;
}

RecordedRun readReport(const std::string& folder) {
  std::error_code error;
  if (!std::filesystem::exists(folder, error) && !error) {
    throw Error(ErrorKind::kBadInput, folder, "no such file");
  }
  const std::string summary_json = textOf(summaryFile(folder));
  return decodeReport(summary_json, textOf(framesFile(folder)), folder);
}

}  // namespace enfilade
