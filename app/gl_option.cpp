#include "app/gl_option.h"

#include <CLI/CLI.hpp>
#include <string>

#include "scene/error.h"

namespace enfilade {

CLI::Option* addGlOption(CLI::App& command, GlBackend& backend) {
  return command
      .add_option_function<std::string>(
          "--gl",
          [&backend](const std::string& name) {
            for (const GlBackend known : {GlBackend::kOsMesa, GlBackend::kEgl}) {
              if (name != glBackendName(known)) continue;
              backend = known;
              return;
            }
            throw Error(ErrorKind::kUsage, "--gl " + name,
                        "no such OpenGL; there are: osmesa, egl");
          },
          "OpenGL that draws: osmesa (software, the same pixels on every machine) or egl (a GPU, "
          "which needs no display)")
      ->type_name("GL")
      ->default_str(glBackendName(backend));
}

}  // namespace enfilade
