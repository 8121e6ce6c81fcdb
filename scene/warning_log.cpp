#include "scene/warning_log.h"

#include <algorithm>
#include <utility>

#include "scene/printable.h"

namespace enfilade {

void WarningLog::add(const std::string& what, const std::string& subject) {
  auto entry = std::find_if(entries_.begin(), entries_.end(),
                            [&](const Entry& e) { return e.what == what; });
  if (entry == entries_.end()) {
    entries_.push_back({what, subject, 0});
    entry = entries_.end() - 1;
  }
  ++entry->count;
}

std::vector<std::string> WarningLog::lines() const {
  std::vector<std::string> lines;
  for (const Entry& entry : entries_) {
    std::string line = entry.what + ": " + entry.first_subject;
    if (entry.count > 1) line += " and " + std::to_string(entry.count - 1) + " more";
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string WarningLog::because() const { return entries_.empty() ? "" : ": " + lines().front(); }

std::string oneLine(const std::string& text, std::size_t length) {
  std::string line = text.substr(0, length);
  if (text.size() > length) {
    // Never half of a UTF-8 character.
    while (!line.empty() && (static_cast<unsigned char>(text[line.size()]) & 0xc0) == 0x80) {
      line.pop_back();
    }
    line += "...";
  }
  return printable(std::move(line));
}

}  // namespace enfilade
