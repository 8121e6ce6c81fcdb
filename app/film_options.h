#pragma once

#include "app/film.h"

namespace CLI {
class App;
}  // namespace CLI

namespace enfilade {

/// Adds --video, --fps and --captions, which set `film`.
void addFilmOptions(CLI::App& command, FilmParameters& film);

}  // namespace enfilade
