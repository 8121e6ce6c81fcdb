#include "app/help_format.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <sstream>
#include <vector>

namespace enfilade {

namespace {

constexpr std::size_t kNameColumns = 26;
constexpr std::size_t kLineColumns = 96;

/// "  NAME   text", the text wrapped beside the name, or below it where the name is long.
std::string entry(const std::string& name, const std::string& text) {
  const std::string indent(kNameColumns, ' ');
  std::string out = "  " + name;
  out +=
      out.size() + 2 > kNameColumns ? "\n" + indent : std::string(kNameColumns - out.size(), ' ');
  std::size_t column = kNameColumns;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (column > kNameColumns && column + 1 + word.size() > kLineColumns) {
      out += "\n" + indent;
      column = kNameColumns;
    }
    if (column > kNameColumns) out += ' ', ++column;
    out += word;
    column += word.size();
  }
  return out + "\n";
}

std::string valueName(const CLI::Option& option) {
  const std::string type = option.get_type_size() == 0 ? "" : option.get_type_name();
  return type.empty() ? type : " " + type;
}

std::string optionEntry(const CLI::Option& option) {
  if (option.get_positional()) return entry(option.get_name(true), option.get_description());
  std::string names;
  for (const std::string& name : option.get_snames()) names += "-" + name + ", ";
  for (const std::string& name : option.get_lnames()) names += "--" + name + ", ";
  names.resize(names.size() - 2);
  std::string text = option.get_description();
  if (!option.get_default_str().empty()) text += " (default: " + option.get_default_str() + ")";
  return entry(names + valueName(option), text);
}

/// "enfilade play HOUSE -o REPORT [OPTIONS]"
std::string usage(const CLI::App& app) {
  std::string line = "Usage: ";
  if (app.get_parent()) line += app.get_parent()->get_name() + " ";
  line += app.get_name();
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_required()) continue;
    line += option->get_positional() ? " " + option->get_name(true)
                                     : " -" + option->get_snames().at(0) + valueName(*option);
  }
  return line + (app.get_subcommands({}).empty() ? " [OPTIONS]\n" : " COMMAND ...\n");
}

std::string group(const CLI::App& app, const std::string& name) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    const bool belongs = option->get_positional() ? name == "Given" : option->get_group() == name;
    if (belongs) text += optionEntry(*option);
  }
  return text.empty() ? text : "\n" + name + ":\n" + text;
}

}  // namespace

std::string HelpFormat::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
  std::string text = app->get_description() + "\n\n" + usage(*app) + group(*app, "Given");
  std::vector<std::string> names = app->get_groups();
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name != "General"; });
  for (const std::string& name : names) text += group(*app, name);
  std::string commands;
  for (const CLI::App* command : app->get_subcommands({})) {
    commands += entry(command->get_name(), command->get_description());
  }
  if (!commands.empty()) text += "\nCommands:\n" + commands;
  return text + "\n" + app->get_footer() + "\n";
}

CLI::App* addCommand(CLI::App& program, const std::string& name, const std::string& description,
                     const std::string& example, bool& quiet) {
  CLI::App* command = program.add_subcommand(name, description);
  command->formatter(std::make_shared<HelpFormat>());
  command->footer("Example:\n  " + example);
  command->set_help_flag("-h,--help", "Print this help and exit")->group("General");
  command->add_flag("-q,--quiet", quiet, "No progress and no messages, errors alone")
      ->group("General");
  return command;
}

CLI::Validator limits(double least, double most) {
  const auto check = [least, most](std::string& text) -> std::string {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return fmt::format("'{}' is no number", text);
    if (value >= least && value <= most) return {};
    return fmt::format("{} is not from {} to {}", text, least, most);
  };
  return {check, ""};
}

CLI::Validator notEmpty() {
  const auto check = [](std::string& name) -> std::string {
    return name.empty() ? "the name is empty" : "";
  };
  return {check, ""};
}

}  // namespace enfilade
