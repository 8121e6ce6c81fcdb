#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

/// What is fuzzed: one function a format of file.  Each reads an input as such a file and holds
/// what comes out to what its reader's header promises.  It may throw Error, which is how readers
/// refuse; anything else that it throws is a fault.
/// Inputs stand in corpus/NAME; the executable fuzz_NAME makes more of them, and corpus_test.cpp
/// reads those that are there.
namespace enfilade::fuzz {

using Bytes = std::span<const std::uint8_t>;

void camera_gltf(Bytes input);  ///< an animated camera: glTF, or the parts of a GLB (see glbOf)
void catalogue(Bytes input);    ///< furniture: a ZIP, or properties \0 an OBJ \0 its materials
void doors(Bytes input);        ///< a tour, played in a house of two doors
void given_graph(Bytes input);  ///< house.json for --graph
void glb(Bytes input);          ///< a GLB, or its parts (see glbOf)
void gltf(Bytes input);         ///< glTF as JSON
void grid(Bytes input);         ///< cells.grid, sealed
void house_json(Bytes input);   ///< house.json, sealed
void image(Bytes input);        ///< PNG or JPEG
void ldi(Bytes input);          ///< a layered depth image's file, sealed
void obj(Bytes input);          ///< an OBJ \0 its materials
void plan(Bytes input);         ///< a floor plan, read and laid out
void report(Bytes input);       ///< summary.json \0 frames.csv
void settings(Bytes input);     ///< view.json
void tour(Bytes input);         ///< a camera path as our JSON
void tum(Bytes input);          ///< a camera path as TUM lines

struct Target {
  std::string_view name;  ///< of its corpus and of its function above
  void (*read)(Bytes);
};

inline void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

/// All of them, by name.
std::span<const Target> allTargets();

/// The text of `input`.
std::string textOf(Bytes input);

/// What stands before the first zero byte, or all of it; takes it and that byte off `input`.
Bytes takePart(Bytes& input);

}  // namespace enfilade::fuzz
