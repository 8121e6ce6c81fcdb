#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace enfilade {

/// What all subcommands share.
struct CommandContext {
  bool quiet = false;         ///< no progress and no messages; errors are still printed
  std::string command_line;   ///< as a shell would take it, for reports
  std::function<void()> run;  ///< set by the subcommand that was named
};

/// Each adds one subcommand to `program`.  `context` must outlive the parse and the run.
void addSampleCommand(CLI::App& program, CommandContext& context);
void addInspectCommand(CLI::App& program, CommandContext& context);
void addPreprocessCommand(CLI::App& program, CommandContext& context);
void addTourCommand(CLI::App& program, CommandContext& context);
void addPlayCommand(CLI::App& program, CommandContext& context);
void addReportCommand(CLI::App& program, CommandContext& context);
void addViewCommand(CLI::App& program, CommandContext& context);

}  // namespace enfilade
