#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "app/report_reader.h"
#include "scene/error.h"

namespace enfilade {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // spreadsheets write it
constexpr std::size_t kShownLength = 40;                     // of a broken cell, in a message
constexpr std::size_t kLongestName = 64;
constexpr std::size_t kMostMethods = 64;
constexpr std::size_t kMostColumns = 256;

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;) {
    cells.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(line);
  return cells;
}

/// Takes rows and gives them to their methods.
class FramesTable {
 public:
  FramesTable(std::string_view head, const std::string& file) : file_(file) {
    for (const std::string_view name : cellsOf(head)) columns_.emplace_back(name);
    if (columns_.size() > kMostColumns) fail(1, "has more columns than there can be");
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (std::find(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(c),
                    columns_[c]) != columns_.begin() + static_cast<std::ptrdiff_t>(c)) {
        fail(1, fmt::format("has the column '{}' twice", columns_[c]));
      }
    }
    method_ = columnNamed("method");
    frame_ = columnNamed("frame");
    frametime_ = columnNamed("frametime_ms");
  }

  void add(std::string_view row, std::size_t line) {
    const std::vector<std::string_view> cells = cellsOf(row);
    if (cells.size() != columns_.size()) {
      fail(line, fmt::format("has {} cells, the head has {}", cells.size(), columns_.size()));
    }
    RecordedMethod& method = methodNamed(cells[method_], line);
    const std::size_t frame = frameOf(cells[frame_], line);
    if (!method.frames.empty() && frame <= method.frames.back()) {
      fail(line, fmt::format("frame {} of {} stands after frame {}", frame, method.name,
                             method.frames.back()));
    }
    method.frames.push_back(frame);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (c == method_ || c == frame_) continue;
      const std::optional<double> value = valueOf(cells[c], c, line);
      method.columns[columns_[c]].push_back(value);
    }
  }

  std::vector<RecordedMethod> take() {
    if (methods_.empty()) throw Error(ErrorKind::kBadInput, file_, "has no rows");
    for (RecordedMethod& method : methods_) {
      std::erase_if(method.columns, [](const auto& column) {
        return std::none_of(column.second.begin(), column.second.end(),
                            [](const auto& value) { return value.has_value(); });
      });
    }
    return std::move(methods_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, file_, fmt::format("line {}: {}", line, reason));
  }

  std::size_t columnNamed(const char* name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end()) {
      throw Error(ErrorKind::kBadInput, file_,
                  fmt::format("has no column '{}': it is no frames.csv of 'enfilade play'", name));
    }
    return static_cast<std::size_t>(found - columns_.begin());
  }

  RecordedMethod& methodNamed(std::string_view name, std::size_t line) {
    if (name.empty()) fail(line, "names no method");
    if (name.size() > kLongestName || std::any_of(name.begin(), name.end(), isControl)) {
      fail(line, "has no method's name in its first cell");
    }
    const auto found = std::find_if(methods_.begin(), methods_.end(),
                                    [&](const RecordedMethod& m) { return m.name == name; });
    if (found != methods_.end()) return *found;
    if (methods_.size() == kMostMethods) fail(line, "names more methods than there can be");
    methods_.push_back({std::string(name), {}, {}});
    return methods_.back();
  }

  std::size_t frameOf(std::string_view cell, std::size_t line) const {
    std::size_t frame = 0;
    const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), frame);
    if (error != std::errc() || stop != cell.data() + cell.size()) {
      fail(line, fmt::format("'{}' is no frame's number", cell.substr(0, kShownLength)));
    }
    return frame;
  }

  std::optional<double> valueOf(std::string_view cell, std::size_t c, std::size_t line) const {
    if (cell.empty() && c != frametime_) return std::nullopt;
    double value = 0;
    const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || stop != cell.data() + cell.size() || !std::isfinite(value)) {
      fail(line, fmt::format("'{}' in {} is no number", cell.substr(0, kShownLength), columns_[c]));
    }
    if (c == frametime_ && value <= 0) fail(line, "a frame cannot take 0 ms or less");
    return value;
  }

  std::string file_;
  std::vector<std::string> columns_;
  std::size_t method_ = 0, frame_ = 0, frametime_ = 0;
  std::vector<RecordedMethod> methods_;
};

}  // namespace

std::vector<RecordedMethod> parseFramesCsv(const std::string& text, const std::string& file) {
  std::string_view rest = text;
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  const auto nextLine = [&] {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  };
  FramesTable table(nextLine(), file);
  for (std::size_t line = 2; !rest.empty(); ++line) table.add(nextLine(), line);
  return table.take();
}

}  // namespace enfilade
