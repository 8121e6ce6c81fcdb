#include "app/warping.h"

#include <fmt/format.h>

#include <map>

namespace enfilade {

namespace {

/// An option whose values are names; the first is the default.
template <class T>
void addChoice(CLI::App& command, const char* name, T& value,
               const std::map<std::string, T>& values, const std::string& standard,
               const std::string& help) {
  command.add_option(name, value, help)
      ->type_name("NAME")
      ->transform(CLI::CheckedTransformer(values).description(""))
      ->default_str(standard)
      ->group("Warping");
}

}  // namespace

void addWarpingOptions(CLI::App& command, Warping& warping) {
  std::map<std::string, Splat> splats;
  std::string splats_help = "How pixels are made of warped samples:";
  for (const SplatInfo& info : allSplats()) {
    splats[info.name] = info.splat;
    splats_help += fmt::format(" {} ({}),", info.name, info.description);
  }
  splats_help.back() = '.';
  std::map<std::string, Holes> holes;
  std::string holes_help = "What stands where no sample fell:";
  for (const HolesInfo& info : allHoles()) {
    holes[info.name] = info.holes;
    holes_help += fmt::format(" {} ({}),", info.name, info.description);
  }
  holes_help.back() = '.';
  addChoice(command, "--splat", warping.splat, splats, infoOf(warping.splat).name, splats_help);
  addChoice(command, "--holes", warping.holes, holes, "none", holes_help);
  addChoice<Clip>(command, "--clip", warping.clip,
                  {{"none", Clip::kNothing}, {"columns", Clip::kColumns}, {"tiles", Clip::kTiles}},
                  "tiles",
                  "What is left out before warping, for the same picture: none, columns (of tiles, "
                  "recursively), tiles.");
}

}  // namespace enfilade
