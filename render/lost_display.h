#pragma once

#include <functional>

namespace enfilade {

/// Has `last_words` called when the X server is gone, at which Xlib ends the program itself, with
/// the exit status of another fault: it is ended by the status of a machine that cannot.  Of what
/// was set before only the last counts.  `last_words` must not touch the window.  Without Xlib, as
/// under Wayland, it does nothing.
void onLostDisplay(std::function<void()> last_words);

}  // namespace enfilade
