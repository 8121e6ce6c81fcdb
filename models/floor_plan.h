#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace enfilade {

/// The name that stands for what lies outside every room.
inline constexpr const char* kOutsideName = "exterior";

enum class OpeningKind : std::uint8_t { kDoor, kWindow, kOpening };

/// "door", "window" or "opening", as plans and portals' extras say it.
const char* kindWord(OpeningKind kind);

/// A straight wall, by its centre line.  Plan points are (x, z) [m].
struct PlanWall {
  glm::dvec2 from{0};
  glm::dvec2 to{0};
  double thickness = 0.25;  ///< [m] [0.05…2]
};

/// A room: the area that walls enclose around `at`.
struct PlanRoom {
  std::string name;
  glm::dvec2 at{0};   ///< any point of the area
  double height = 3;  ///< [m] [2…20] from floor to ceiling
  std::string floor;  ///< names of finishes
  std::string walls;  ///< its picture spans the wall's height
  std::string ceiling;
  std::string trim;  ///< skirting, cornice, architraves, window frames
};

/// A door, window or open passage through a wall.
struct PlanOpening {
  OpeningKind kind = OpeningKind::kDoor;
  std::array<std::string, 2> between;  ///< two rooms, or a room and "exterior"; the first states it
  glm::dvec2 at{0};                    ///< its middle, on the wall's centre line
  double width = 1;                    ///< [m] [0.2…20]
  double sill = 0;                     ///< [m] [≥ 0] above the floor
  double head = 2.1;                   ///< [m] [> sill] above the floor
  glm::ivec2 panes{0};                 ///< [0…12] panes of glass across and up; 0: no frame
};

/// One shape of a piece, with the finish that it wears.
struct PlanPart {
  std::string shape;                      ///< name of a shape, see shapeNames()
  std::map<std::string, double> numbers;  ///< the shape's own parameters
  std::string finish;
  glm::dvec3 at{0};   ///< [m] from the piece's foot
  double turn = 0;    ///< [degrees] counter-clockwise seen from above
  double detail = 1;  ///< [0.01…100] share of the triangles, beside the shape's own
};

/// A lamp in a piece: shines to all sides.
struct PlanLight {
  glm::dvec3 at{0};     ///< [m] from the piece's foot
  glm::dvec3 color{1};  ///< sRGB, 0…1
  double candela = 0;   ///< [0…1e6]
};

/// Something that can stand in rooms, many times.
struct PlanPiece {
  std::string name;
  std::vector<PlanPart> parts;  ///< at least one, unless it is furniture of a catalogue
  std::string furniture;        ///< its id in the FurnitureLibrary; empty: none
  glm::dvec3 size{0};           ///< [m] of furniture: width, height, depth; 0: as in the catalogue
  std::optional<PlanLight> light{};
};

/// A piece in its place.
struct PlanFitting {
  std::string piece;
  std::string on;    ///< the piece that it stands on, or empty
  std::string room;  ///< a room's name, or "exterior"
  glm::dvec2 at{0};
  double height = 0;     ///< [m] above the floor (of the exterior: the ground)
  double turn = 0;       ///< [degrees] counter-clockwise seen from above; 0 looks to +z
  double scale = 1;      ///< [0.01…100]
  bool on_wall = false;  ///< moved to the nearest wall's face and turned away from it
};

/// A stairwell or light well: a level rectangle cut through a floor, the ceiling below it and what
/// lies between.
struct PlanWell {
  std::array<std::string, 2> between;  ///< the room whose floor it is cut through, the one below
  glm::dvec2 low{0}, high{0};          ///< opposite corners, low < high
};

/// The look of a surface.
struct PlanFinish {
  std::string name;
  std::string pattern;             ///< see patternNames(); "plain" has no picture
  std::vector<glm::dvec3> colors;  ///< sRGB, 0…1, at least one
  double size = 1;                 ///< [m] [> 0] that the picture spans
  std::uint32_t seed = 0;
  bool double_sided = false;
  bool unlit = false;  ///< shows its colours as they are, whichever way it faces
};

/// One level of a building, from its floor to the next one, or to the roof.
struct PlanStorey {
  std::string name = "ground";
  double floor = 0;   ///< [m] level of all its rooms' floors
  double height = 4;  ///< [m] [2…40] from the floor to the next storey's floor, or to the roof
  std::vector<PlanWall> walls;
  std::vector<glm::dvec2> solids;  ///< a point in each area that is masonry, not a room
  std::vector<PlanRoom> rooms;
  std::vector<PlanOpening> openings;
  std::vector<PlanWell> wells;  ///< through this storey's floor
  std::vector<PlanFitting> fittings;

  double top() const { return floor + height; }
  /// Index in `rooms`, or -1.
  int roomIndex(const std::string& room) const;
};

/// A building, as its author describes it.
struct FloorPlan {
  std::string name;
  std::string copyright;
  std::uint64_t triangles = 150000;  ///< [≥ 0] of the raised building, unless told otherwise
  bool bake_light = false;           ///< rooms are meant to be seen in baked light
  double ground = 0;                 ///< [m] [≤ floor] level of the ground outside
  double margin = 20;                ///< [m] [> 0] of ground around the building
  std::string facade;                ///< finishes of the outside
  std::string roof;
  std::string ground_finish;
  std::string outside_trim;
  std::vector<PlanStorey> storeys;  ///< at least one, upward, each where the one below ends
  std::map<std::string, PlanPiece> pieces;
  std::map<std::string, PlanFinish> finishes;

  /// Whether any piece is furniture of a catalogue.
  bool hasFurniture() const;
};

/// Reads a plan (models/README.md describes the format) and checks all that can be told without
/// laying out the walls: types, ranges, misspelt keys, names that stand for nothing.  Throws Error
/// (kBadInput): "SUBJECT: storeys[0].rooms[2].height: must be from 2 to 20, is 0.5".
FloorPlan parseFloorPlan(const std::string& json_text, const std::string& subject);

/// Checks that every name the plan uses stands for something in it, and that no name would be
/// mistaken for a marker's.  Throws Error (kBadInput).
void checkNames(const FloorPlan& plan, const std::string& subject);

}  // namespace enfilade
