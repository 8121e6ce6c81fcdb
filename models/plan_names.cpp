#include <fmt/format.h>

#include <set>

#include "models/floor_plan.h"
#include "scene/error.h"

namespace enfilade {
namespace {

/// Every name that the plan uses must stand for something in it.
class NameCheck {
 public:
  NameCheck(const FloorPlan& plan, const std::string& subject) : plan_(plan), subject_(subject) {}

  void run() const {
    std::set<std::string> names;
    for (std::size_t i = 0; i < plan_.storeys.size(); ++i) {
      checkRooms(plan_.storeys[i], names);
      checkOpenings(i);
      checkWells(i);
      checkFittings(i);
    }
    for (const auto& [name, piece] : plan_.pieces) {
      plainName(name);
      for (const PlanPart& part : piece.parts) finish(part.finish, "pieces." + name);
    }
    for (const std::string& name :
         {plan_.facade, plan_.roof, plan_.ground_finish, plan_.outside_trim})
      finish(name, "outside");
  }

 private:
  void checkRooms(const PlanStorey& storey, std::set<std::string>& names) const {
    for (const PlanRoom& r : storey.rooms) {
      plainName(r.name);
      if (!names.insert(r.name).second) fail("two rooms are called \"" + r.name + "\"");
      for (const std::string& name : {r.floor, r.walls, r.ceiling, r.trim})
        finish(name, "room " + r.name);
    }
    if (storey.rooms.empty()) fail("storey " + storey.name + " has no rooms");
  }

  void checkOpenings(std::size_t storey) const {
    const PlanStorey& plan = plan_.storeys[storey];
    for (std::size_t i = 0; i < plan.openings.size(); ++i)
      for (const std::string& name : plan.openings[i].between)
        room(name, storey, place(storey, "openings", i));
  }

  void checkWells(std::size_t storey) const {
    const PlanStorey& plan = plan_.storeys[storey];
    if (storey == 0 && !plan.wells.empty())
      fail(place(storey, "wells", 0) + ": there is no storey below");
    for (std::size_t i = 0; i < plan.wells.size(); ++i)
      for (const std::size_t side : {0u, 1u}) {
        const std::string& name = plan.wells[i].between[side];
        if (plan_.storeys[storey - side].roomIndex(name) < 0)
          fail(fmt::format("{}: there is no room \"{}\" on storey {}", place(storey, "wells", i),
                           name, plan_.storeys[storey - side].name));
      }
  }

  void checkFittings(std::size_t storey) const {
    const PlanStorey& plan = plan_.storeys[storey];
    for (std::size_t i = 0; i < plan.fittings.size(); ++i) {
      const PlanFitting& f = plan.fittings[i];
      const std::string where = place(storey, "fittings", i);
      room(f.room, storey, where);
      for (const std::string& name : {f.piece, f.on})
        if (!name.empty() && !plan_.pieces.contains(name))
          fail(where + ": there is no piece \"" + name + "\"");
      if (!f.on.empty() && plan_.pieces.at(f.on).furniture.empty() &&
          !plan_.pieces.at(f.on).parts[0].numbers.contains("height"))
        fail(where + ": nothing can stand on \"" + f.on + "\", which has no height");
    }
  }

  static std::string place(std::size_t storey, const char* list, std::size_t i) {
    return fmt::format("storeys[{}].{}[{}]", storey, list, i);
  }

  void room(const std::string& name, std::size_t storey, const std::string& where) const {
    if (name == kOutsideName || plan_.storeys[storey].roomIndex(name) >= 0) return;
    fail(fmt::format("{}: there is no room \"{}\"{}", where, name,
                     plan_.storeys.size() > 1 ? " on storey " + plan_.storeys[storey].name : ""));
  }

  void finish(const std::string& name, const std::string& place) const {
    if (!plan_.finishes.contains(name)) fail(place + ": there is no finish \"" + name + "\"");
  }

  /// Readers of the model take nodes by these endings.
  void plainName(const std::string& name) const {
    for (const char* reserved : {"-room", "-portal", "-bound"})
      if (name.find(reserved) != std::string::npos)
        fail(fmt::format("\"{}\": names must not contain \"{}\", which marks cells and portals",
                         name, reserved));
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, subject_, reason);
  }

  const FloorPlan& plan_;
  const std::string& subject_;
};

}  // namespace

const char* kindWord(OpeningKind kind) {
  switch (kind) {
    case OpeningKind::kDoor:
      return "door";
    case OpeningKind::kWindow:
      return "window";
    case OpeningKind::kOpening:
      break;
  }
  return "opening";
}

int PlanStorey::roomIndex(const std::string& room) const {
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (rooms[i].name == room) return static_cast<int>(i);
  return -1;
}

void checkNames(const FloorPlan& plan, const std::string& subject) {
  NameCheck(plan, subject).run();
}

}  // namespace enfilade
