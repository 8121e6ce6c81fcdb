#include "models/java_properties.h"

#include <cctype>
#include <vector>

namespace enfilade {
namespace {

void appendUtf8(unsigned code, std::string& text) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0 | code >> 6);
    text += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    text += static_cast<char>(0xe0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3f));
    text += static_cast<char>(0x80 | (code & 0x3f));
  }
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f'; }

/// The lines that are no comments, those joined that go on, their first blanks left out.
std::vector<std::string> logicalLines(std::span<const std::uint8_t> bytes) {
  std::vector<std::string> lines;
  std::string line;
  bool goes_on = false;
  const auto end = [&](std::string physical) {
    std::size_t start = 0;
    while (start < physical.size() && isBlank(physical[start])) ++start;
    physical.erase(0, start);
    if (!goes_on && (physical.empty() || physical[0] == '#' || physical[0] == '!')) return;
    std::size_t slashes = 0;
    while (slashes < physical.size() && physical[physical.size() - 1 - slashes] == '\\') ++slashes;
    goes_on = slashes % 2 == 1;
    if (goes_on) physical.pop_back();
    line += physical;
    if (goes_on) return;
    lines.push_back(line);
    line.clear();
  };
  std::string physical;
  std::uint8_t before = 0;
  for (const std::uint8_t byte : bytes) {
    const bool same_end = byte == '\n' && before == '\r';
    before = byte;
    if (same_end) continue;
    if (byte == '\n' || byte == '\r') {
      end(physical);
      physical.clear();
    } else {
      physical += static_cast<char>(byte);
    }
  }
  end(physical);
  if (goes_on) lines.push_back(line);
  return lines;
}

/// Part of a line without escapes, as UTF-8.
std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      appendUtf8(static_cast<unsigned char>(text[i]), result);
      continue;
    }
    const char c = text[++i];
    unsigned code = 0;
    std::size_t digits = 0;
    while (c == 'u' && digits < 4 && i + 1 + digits < text.size() &&
           std::isxdigit(static_cast<unsigned char>(text[i + 1 + digits])) != 0) {
      code =
          16 * code + static_cast<unsigned>(std::stoi(text.substr(i + 1 + digits, 1), nullptr, 16));
      ++digits;
    }
    if (digits == 4) {
      appendUtf8(code, result);
      i += 4;
    } else {
      appendUtf8(static_cast<unsigned char>(c == 'n' ? '\n' : c == 't' ? '\t' : c), result);
    }
  }
  return result;
}

}  // namespace

std::map<std::string, std::string> readJavaProperties(std::span<const std::uint8_t> bytes) {
  std::map<std::string, std::string> properties;
  for (const std::string& line : logicalLines(bytes)) {
    std::size_t end = 0;
    while (end < line.size() && line[end] != '=' && line[end] != ':' && !isBlank(line[end])) {
      end += line[end] == '\\' ? 2 : 1;
    }
    end = std::min(end, line.size());
    std::size_t value = end;
    while (value < line.size() && isBlank(line[value])) ++value;
    if (value < line.size() && (line[value] == '=' || line[value] == ':')) ++value;
    while (value < line.size() && isBlank(line[value])) ++value;
    properties[unescaped(line.substr(0, end))] = unescaped(line.substr(value));
  }
  return properties;
}

}  // namespace enfilade
