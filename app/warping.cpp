#include "app/warping.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "scene/error.h"

namespace enfilade {

namespace {

template <class T>
struct Choice {
  T value;
  std::string name, description;
};

template <class T>
using Choices = std::vector<Choice<T>>;

Choices<Splat> splats() {
  Choices<Splat> choices;
  for (const SplatInfo& s : allSplats()) choices.push_back({s.splat, s.name, s.description});
  return choices;
}

Choices<Holes> holes() {
  Choices<Holes> choices;
  for (const HolesInfo& h : allHoles()) choices.push_back({h.holes, h.name, h.description});
  return choices;
}

Choices<Clip> clips() {
  return {{Clip::kNothing, "none", "nothing"},
          {Clip::kColumns, "columns", "columns of tiles, recursively"},
          {Clip::kTiles, "tiles", "each tile by itself"}};
}

template <class T>
void addChoice(CLI::App& command, const char* option, std::string& name, const Choices<T>& choices,
               std::string help) {
  for (const Choice<T>& choice : choices) {
    help += fmt::format("{} {} ({})", &choice == &choices.front() ? "" : ",", choice.name,
                        choice.description);
  }
  command.add_option(option, name, help)
      ->type_name("NAME")
      ->capture_default_str()
      ->group("Warping");
}

template <class T>
T parse(const std::string& option, const std::string& name, const Choices<T>& choices) {
  std::string names;
  for (const Choice<T>& choice : choices) {
    if (choice.name == name) return choice.value;
    names += (names.empty() ? "" : ", ") + choice.name;
  }
  throw Error(ErrorKind::kUsage, option + " " + name, "no such choice; there are: " + names);
}

}  // namespace

void addWarpingOptions(CLI::App& command, WarpingNames& names) {
  addChoice(command, "--splat", names.splat, splats(), "How pixels are made of warped samples:");
  addChoice(command, "--holes", names.holes, holes(), "What stands where no sample fell:");
  addChoice(command, "--clip", names.clip, clips(),
            "What is left out before the warp, for the same picture:");
}

Warping parseWarping(const WarpingNames& names) {
  return {parse("--splat", names.splat, splats()), parse("--holes", names.holes, holes()),
          parse("--clip", names.clip, clips())};
}

}  // namespace enfilade
