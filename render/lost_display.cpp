#include "render/lost_display.h"

#include <dlfcn.h>
#include <unistd.h>

#include <utility>

#include "scene/error.h"

namespace enfilade {
namespace {

struct Display;  // Xlib's own

std::function<void()>& lastWords() {
  static std::function<void()> last_words;
  return last_words;
}

int endProgram(Display*) {
  if (const auto last_words = std::exchange(lastWords(), nullptr)) last_words();
  _exit(static_cast<int>(ErrorKind::kMachine));
}

}  // namespace

void onLostDisplay(std::function<void()> last_words) {
  lastWords() = std::move(last_words);
  // The one that GLFW has loaded.
  void* xlib = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (xlib == nullptr) return;
  using Handler = int (*)(Display*);
  using SetHandler = Handler (*)(Handler);
  const auto set = reinterpret_cast<SetHandler>(dlsym(xlib, "XSetIOErrorHandler"));
  if (set != nullptr) set(&endProgram);
  dlclose(xlib);
}

}  // namespace enfilade
