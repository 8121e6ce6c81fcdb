#pragma once

#include <optional>

#include "app/frame_painter.h"

namespace CLI {
class App;
}  // namespace CLI

namespace enfilade {

/// Adds --memory, which sets `mib`; left empty: no limit.
void addMemoryOption(CLI::App& command, std::optional<double>& mib);

/// The limit in bytes.  Throws Error (kUsage) for one on images that are made while walking.
std::optional<std::size_t> memoryLimit(const std::optional<double>& mib, ImageSource source);

}  // namespace enfilade
