#include "portals/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace enfilade {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kColumns = 100;
constexpr std::size_t kIndent = 2;

/// The text of `json` on one line.
std::string lineOf(const ordered_json& json) {
  if (json.is_primitive() || json.empty()) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  }
  std::string text(1, json.is_array() ? '[' : '{');
  for (auto item = json.begin(); item != json.end(); ++item) {
    if (item != json.begin()) text += ", ";
    if (json.is_object()) text += lineOf(item.key()) + ": ";
    text += lineOf(*item);
  }
  return text + (json.is_array() ? ']' : '}');
}

/// Appends the items of an array one after the other, as many on a line as fit.
void appendFlowing(const ordered_json& array, std::size_t column, std::string& text) {
  const std::size_t indent = column + 1;
  text += '[';
  ++column;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string item = lineOf(array[i]) + (i + 1 < array.size() ? "," : "]");
    if (i > 0 && column + 1 + item.size() > kColumns) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (i > 0) {
      text += ' ';
      ++column;
    }
    text += item;
    column += item.size();
  }
}

void append(const ordered_json& json, std::size_t indent, std::string& text) {
  const std::size_t column = text.size() - (text.rfind('\n') + 1);
  const std::string line = lineOf(json);
  const bool flowing = json.is_array() && !std::any_of(json.begin(), json.end(), [](const auto& i) {
                         return i.is_object() || i.is_string();
                       });
  if (json.is_primitive() || (indent > 0 && column + line.size() < kColumns)) {
    text += line;
  } else if (flowing) {
    appendFlowing(json, column, text);
  } else {
    const std::string separator = '\n' + std::string(indent + kIndent, ' ');
    text += json.is_array() ? '[' : '{';
    for (auto item = json.begin(); item != json.end(); ++item) {
      text += (item == json.begin() ? "" : ",") + separator;
      if (json.is_object()) text += lineOf(item.key()) + ": ";
      append(*item, indent + kIndent, text);
    }
    text += '\n' + std::string(indent, ' ') + (json.is_array() ? ']' : '}');
  }
}

}  // namespace

std::string jsonText(const ordered_json& json) {
  std::string text;
  append(json, 0, text);
  return text + '\n';
}

double shortDecimal(float value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = value;
  std::from_chars(text.data(), end, number);
  return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

}  // namespace enfilade
