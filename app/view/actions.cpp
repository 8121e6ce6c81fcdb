#include "app/view/actions.h"

#include <array>

#include "app/methods.h"

namespace enfilade {

namespace {

using A = Action;

constexpr const char* kWalking = "Walking";
constexpr const char* kPicture = "Picture";
constexpr const char* kLooking = "Looking into it";
constexpr const char* kKeeping = "Keeping";
constexpr const char* kWindow = "Window";

const std::array kBindings = {
    Binding{kWalking, "W A S D", "walk; with Shift faster", {}},
    Binding{kWalking, "↑ ↓ ← →", "walk and turn", {}},
    Binding{kWalking, "mouse", "look; click to take it, Esc to let go", {}},
    Binding{kWalking, "E Q", "up and down, flying", {}},
    Binding{kWalking, "F", "fly or walk", Command{A::kFly}, 'F'},
    Binding{kWalking, "O", "open or shut the door ahead", Command{A::kDoor}, 'O'},
    Binding{kWalking, "+ or wheel", "faster", Command{A::kFaster}, '='},
    Binding{kWalking, "-", "slower", Command{A::kSlower}, '-'},
    Binding{kWalking, "J", "jump to a cell by its name", Command{A::kJump}, 'J'},
    Binding{kWalking, "Home", "back to the start", Command{A::kStart}, key::kHome},

    Binding{kPicture, "1", "geometry: everything", Command{A::kMethod, 1}},
    Binding{kPicture, "2", "raycast: everything, by rays", Command{A::kMethod, 2}},
    Binding{kPicture, "3", "culling: what portals show", Command{A::kMethod, 3}},
    Binding{kPicture, "4", "texture: far portals as pictures", Command{A::kMethod, 4}},
    Binding{kPicture, "5", "warp: one reference image warped", Command{A::kMethod, 5}},
    Binding{kPicture, "6", "warp2: the two nearest", Command{A::kMethod, 6}},
    Binding{kPicture, "7", "ldi: a layered depth image", Command{A::kMethod, 7}},
    Binding{kPicture, "X", "split screen; drag the line", Command{A::kSplit}, 'X'},
    Binding{kPicture, "Shift 1…7", "method right of the line", {}},
    Binding{kPicture, "]", "wider field of view", Command{A::kWider}, ']'},
    Binding{kPicture, "[", "narrower", Command{A::kNarrower}, '['},
    Binding{kPicture, "N", "full resolution, however slow", Command{A::kSteady}, 'N'},

    Binding{kLooking, "P", "portals, by what they show", Command{A::kPortals}, 'P'},
    Binding{kLooking, "C", "cells' names", Command{A::kNames}, 'C'},
    Binding{kLooking, "I", "tint what is an image", Command{A::kImages}, 'I'},
    Binding{kLooking, "U", "mark uncovered pixels", Command{A::kUncovered}, 'U'},
    Binding{kLooking, "Y", "layers of LDIs", Command{A::kLayers}, 'Y'},
    Binding{kLooking, "V", "wire frame", Command{A::kWires}, 'V'},
    Binding{kLooking, "Z", "freeze culling and look at it from elsewhere", Command{A::kFreeze},
            'Z'},

    Binding{kKeeping, "R", "record a path; again to keep it", Command{A::kRecord}, 'R'},
    Binding{kKeeping, "T", "play the path or tour", Command{A::kPlayTour}, 'T'},
    Binding{kKeeping, "F12", "keep the picture", Command{A::kScreenshot}, key::kF12},
    Binding{kKeeping, "Shift F12", "the same with the panels", Command{A::kWindowShot}, key::kF12,
            true},

    Binding{kWindow, "F1 or H", "this help; click a line to do it", Command{A::kHelp}, key::kF1},
    Binding{kWindow, "M", "plan; click it to go there", Command{A::kPlan}, 'M'},
    Binding{kWindow, "L", "next storey on the plan", Command{A::kPlanStorey}, 'L'},
    Binding{kWindow, "G", "frame times", Command{A::kGraph}, 'G'},
    Binding{kWindow, "Tab", "all panels", Command{A::kPanels}, key::kTab},
    Binding{kWindow, "F11", "full screen", Command{A::kFullScreen}, key::kF11},
    Binding{kWindow, "Esc", "let go of the mouse, close what is open", Command{A::kFreePointer},
            key::kEscape},
    Binding{kWindow, "Ctrl Q", "quit", Command{A::kQuit}, 'Q', false, true},
};

}  // namespace

std::span<const Binding> bindings() { return kBindings; }

std::optional<Command> commandOf(const WindowEvent& event) {
  const int digit = event.key - '0';
  if (digit >= 1 && digit <= static_cast<int>(allMethods().size()) && !event.control) {
    return Command{event.shift ? A::kSplitMethod : A::kMethod, digit};
  }
  if (event.key == 'H' && !event.control) return Command{A::kHelp};
  if (event.key == '+') return Command{A::kFaster};
  for (const Binding& binding : kBindings) {
    if (!binding.command || binding.key == 0 || binding.key != event.key) continue;
    if (binding.control != event.control) continue;
    const bool minds_shift = binding.key == key::kF12;
    if (!minds_shift || binding.shift == event.shift) return binding.command;
  }
  return std::nullopt;
}

}  // namespace enfilade
