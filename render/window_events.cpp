#include "render/window_events.h"

#include <map>

namespace enfilade {

std::string keyName(Key key) {
  static const std::map<Key, const char*> kNames = {{key::kEscape, "Esc"},
                                                    {key::kEnter, "Enter"},
                                                    {key::kTab, "Tab"},
                                                    {key::kBackspace, "Backspace"},
                                                    {key::kRight, "→"},
                                                    {key::kLeft, "←"},
                                                    {key::kDown, "↓"},
                                                    {key::kUp, "↑"},
                                                    {key::kPageUp, "Page up"},
                                                    {key::kPageDown, "Page down"},
                                                    {key::kHome, "Home"},
                                                    {key::kEnd, "End"},
                                                    {key::kLeftShift, "Shift"},
                                                    {key::kRightShift, "Shift"},
                                                    {key::kLeftControl, "Ctrl"},
                                                    {key::kRightControl, "Ctrl"},
                                                    {' ', "Space"}};
  if (key >= key::kF1 && key <= key::kF12) return "F" + std::to_string(key - key::kF1 + 1);
  const auto found = kNames.find(key);
  if (found != kNames.end()) return found->second;
  return key > 32 && key < 127 ? std::string(1, static_cast<char>(key)) : "?";
}

}  // namespace enfilade
