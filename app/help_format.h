#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace enfilade {

/// Help that a newcomer can act on: what must be given stands in the usage line, each option has
/// its default after its description, lines fit a terminal of 96 columns.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
};

/// A subcommand with our help, --quiet, and an example at its end.
CLI::App* addCommand(CLI::App& program, const std::string& name, const std::string& description,
                     const std::string& example, bool& quiet);

/// Refuses what is no number from `least` to `most`.
CLI::Validator limits(double least, double most);

/// Refuses the empty name of a file or folder, as of a variable of the shell that is not set.
CLI::Validator notEmpty();

}  // namespace enfilade
