#pragma once

#include <CLI/CLI.hpp>

#include "app/film.h"

namespace enfilade {

/// Adds --video, --fps and --captions, which set `film`.
void addFilmOptions(CLI::App& command, FilmParameters& film);

}  // namespace enfilade
