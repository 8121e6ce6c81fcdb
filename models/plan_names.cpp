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
    checkRooms();
    checkOpenings();
    checkFittings();
    for (const auto& [name, piece] : plan_.pieces) {
      plainName(name);
      for (const PlanPart& part : piece.parts) finish(part.finish, "pieces." + name);
    }
    for (const std::string& name :
         {plan_.facade, plan_.roof, plan_.ground_finish, plan_.outside_trim})
      finish(name, "outside");
  }

 private:
  void checkRooms() const {
    std::set<std::string> names;
    for (const PlanRoom& r : plan_.rooms) {
      plainName(r.name);
      if (!names.insert(r.name).second) fail("two rooms are called \"" + r.name + "\"");
      for (const std::string& name : {r.floor, r.walls, r.ceiling, r.trim})
        finish(name, "room " + r.name);
    }
    if (plan_.rooms.empty()) fail("has no rooms");
  }

  void checkOpenings() const {
    for (std::size_t i = 0; i < plan_.openings.size(); ++i)
      for (const std::string& name : plan_.openings[i].between)
        room(name, fmt::format("openings[{}]", i));
  }

  void checkFittings() const {
    for (std::size_t i = 0; i < plan_.fittings.size(); ++i) {
      const PlanFitting& f = plan_.fittings[i];
      const std::string place = fmt::format("fittings[{}]", i);
      room(f.room, place);
      for (const std::string& name : {f.piece, f.on})
        if (!name.empty() && !plan_.pieces.contains(name))
          fail(place + ": there is no piece \"" + name + "\"");
      if (!f.on.empty() && plan_.pieces.at(f.on).furniture.empty() &&
          !plan_.pieces.at(f.on).parts[0].numbers.contains("height"))
        fail(place + ": nothing can stand on \"" + f.on + "\", which has no height");
    }
  }

  void room(const std::string& name, const std::string& place) const {
    if (name != kOutsideName && plan_.roomIndex(name) < 0)
      fail(place + ": there is no room \"" + name + "\"");
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

int FloorPlan::roomIndex(const std::string& room) const {
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (rooms[i].name == room) return static_cast<int>(i);
  return -1;
}

void checkNames(const FloorPlan& plan, const std::string& subject) {
  NameCheck(plan, subject).run();
}

}  // namespace enfilade
