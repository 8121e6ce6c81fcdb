#pragma once

#include <optional>
#include <span>
#include <string>

#include "render/window_events.h"

namespace enfilade {

/// What a person can have the window do by a key, a click on its line in the help, or a controller.
enum class Action : std::uint8_t {
  kMethod,       ///< `number`: which, from 1
  kSplitMethod,  ///< likewise, right of the line
  kSplit,
  kFly,
  kDoor,
  kFaster,
  kSlower,
  kWider,
  kNarrower,
  kJump,
  kStart,
  kRecord,
  kPlayTour,
  kPlan,
  kPlanStorey,
  kGraph,
  kPanels,
  kHelp,
  kFullScreen,
  kScreenshot,
  kWindowShot,
  kFreeze,
  kPortals,
  kNames,
  kImages,
  kUncovered,
  kLayers,
  kWires,
  kSteady,
  kFreePointer,
  kQuit,
};

struct Command {
  Action action = Action::kHelp;
  int number = 0;

  bool operator==(const Command&) const = default;
};

/// A line of the help: what a key does.
struct Binding {
  const char* group;
  const char* keys;                ///< as a person reads them
  const char* what;                ///< what happens
  std::optional<Command> command;  ///< nothing: what is held down, not pressed
  Key key = 0;
  bool shift = false, control = false;
};

/// All lines of the help, group after group.
std::span<const Binding> bindings();

/// What a key that went down stands for.
std::optional<Command> commandOf(const WindowEvent& event);

}  // namespace enfilade
