#include "portals/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace enfilade {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kColumns = 100;

std::string inlineText(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

bool holdsOnlyScalars(const ordered_json& json) {
  return std::all_of(json.begin(), json.end(),
                     [](const ordered_json& item) { return item.is_primitive(); });
}

/// Numbers, or points: what reads best side by side.
bool isFlowing(const ordered_json& array) {
  return std::all_of(array.begin(), array.end(), [](const ordered_json& item) {
    return item.is_number() || (item.is_array() && holdsOnlyScalars(item));
  });
}

void append(const ordered_json& json, std::size_t indent, std::string& text);

void appendFlowing(const ordered_json& array, std::size_t indent, std::string& text) {
  text += '[';
  std::size_t column = text.size() - (text.rfind('\n') + 1);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string item = inlineText(array[i]) + (i + 1 < array.size() ? "," : "]");
    if (i > 0 && column + 1 + item.size() > kColumns) {
      text += '\n' + std::string(indent + 1, ' ');
      column = indent + 1;
    } else if (i > 0) {
      text += ' ';
      ++column;
    }
    text += item;
    column += item.size();
  }
}

void append(const ordered_json& json, std::size_t indent, std::string& text) {
  if (json.is_primitive() || json.empty()) {
    text += inlineText(json);
  } else if (json.is_array() && isFlowing(json)) {
    appendFlowing(json, indent, text);
  } else {
    text += json.is_array() ? '[' : '{';
    const std::string line = '\n' + std::string(indent + 1, ' ');
    bool first = true;
    for (auto item = json.begin(); item != json.end(); ++item) {
      text += (first ? "" : ",") + line;
      if (json.is_object()) text += inlineText(item.key()) + ": ";
      append(*item, indent + 1, text);
      first = false;
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
