#include "app/program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <sstream>
#include <vector>

#include "app/commands.h"
#include "app/console.h"
#include "app/help_format.h"
#include "scene/error.h"
#include "scene/printable.h"

namespace enfilade {

namespace {

/// What `program` offers: subcommands, or long option names.
std::string listOfCommands(const CLI::App& program) {
  std::string list;
  for (const CLI::App* command : program.get_subcommands({})) {
    list += (list.empty() ? "" : ", ") + command->get_name();
  }
  return list;
}

std::string listOfOptions(const CLI::App& command) {
  std::string list;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || option->get_lnames().empty()) continue;
    list += (list.empty() ? "--" : ", --") + option->get_lnames().front();
  }
  return list;
}

[[noreturn]] void throwUsage(const std::string& subject, const std::string& reason) {
  throw Error(ErrorKind::kUsage, subject, reason);
}

/// Throws for the first argument that nobody took, if there is one.
void rejectExtras(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  const std::vector<std::string> extras = program.remaining(true);
  if (extras.empty()) return;
  const std::string& extra = extras.front();
  if (extra.size() > 1 && extra[0] == '-') {
    const std::string name = extra.substr(0, extra.find('='));
    if (!chosen.empty() && command.get_option_no_throw(name) != nullptr) {
      throwUsage(extra,
                 "belongs behind the command: enfilade " + command.get_name() + " … " + name);
    }
    throwUsage(extra, "no such option; there are: " + listOfOptions(command));
  }
  if (chosen.empty()) throwUsage(extra, "no such command; there are: " + listOfCommands(program));
  throwUsage(extra, "one argument too many; see 'enfilade " + command.get_name() + " --help'");
}

/// Turns what CLI11 says of a command line into our one line.
[[noreturn]] void rethrowAsUsage(const CLI::App& program, const CLI::ParseError& error) {
  rejectExtras(program);
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const std::string name = chosen.empty() ? "" : " " + chosen.front()->get_name();
  const std::string what = error.what();
  const std::size_t twice = what.find(": At Most 1 required but received ");
  throwUsage("", (twice == std::string::npos ? what : what.substr(0, twice) + " is given twice") +
                     "; see 'enfilade" + name + " --help'");
}

void addCommands(CLI::App& program, CommandContext& context) {
  addSampleCommand(program, context);
  addInspectCommand(program, context);
  addPreprocessCommand(program, context);
  addTourCommand(program, context);
  addPlayCommand(program, context);
  addReportCommand(program, context);
  addViewCommand(program, context);
}

}  // namespace

void printError(const std::string& message) {
  std::fprintf(stderr, "enfilade: %s\n", printable(message).c_str());
}

int runProgram(int argc, char** argv) {
  CommandContext context;
  context.command_line = shellLine(argc, argv);
  CLI::App program("Walks through buildings too heavy for the machine: cells, portals and images.",
                   "enfilade");
  program.formatter(std::make_shared<HelpFormat>());
  program.set_help_flag("-h,--help", "Print this help and exit")->group("General");
  program.set_version_flag("--version", "enfilade " ENFILADE_VERSION, "Print the version and exit")
      ->group("General");
  program.footer(
      "Start with:\n  enfilade preprocess house.glb -o house && enfilade play house -o report\n"
      "Help for a command: enfilade COMMAND --help");
  addCommands(program, context);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked_for_help) {
    std::ostringstream text;
    program.exit(asked_for_help, text, text);
    printResult(text.str());
    return 0;
  } catch (const CLI::ParseError& error) {
    rethrowAsUsage(program, error);
  }
  if (!context.run) throwUsage("", "no command given; there are: " + listOfCommands(program));
  context.run();
  return 0;
}

}  // namespace enfilade
