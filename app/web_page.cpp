#include "app/web_page.h"

#include "app/plan_marks.h"
#include "app/report_assets.h"

namespace enfilade {

namespace {

using Json = nlohmann::ordered_json;

/// JSON that may stand inside a script element: nothing in it can end the element.
std::string forScript(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

void replaceOnce(std::string& text, const std::string& mark, std::string_view by) {
  const std::size_t at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), by);
}

/// As XML, but with its line ends.
std::string escapedLines(const std::string& words) {
  std::string text;
  std::size_t start = 0;
  for (std::size_t end; (end = words.find('\n', start)) != std::string::npos; start = end + 1) {
    text += escapedXml(words.substr(start, end - start)) + '\n';
  }
  return text + escapedXml(words.substr(start));
}

}  // namespace

std::string assembledPage(std::string_view page, std::initializer_list<std::string_view> scripts,
                          const Json& data, const std::string& words) {
  std::string script;
  for (const std::string_view part : scripts) script += part;
  std::string whole(page);
  // The data last: what a person named must not be taken for a mark.
  replaceOnce(whole, "/*CHART STYLE*/", kChartStyle);
  replaceOnce(whole, "/*STYLE*/", kReportStyle);
  replaceOnce(whole, "/*CHART LIBRARY*/", kChartLibrary);
  replaceOnce(whole, "/*SCRIPT*/", script);
  replaceOnce(whole, "/*DATA*/", forScript(data));
  replaceOnce(whole, "<!--WORDS-->", escapedLines(words));
  return whole;
}

}  // namespace enfilade
