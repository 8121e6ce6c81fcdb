#include "visibility/object_index.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "visibility/screen_matrix.h"

namespace enfilade {

namespace {

/// The planes of the view volume: the four through the eye, then near and far.
std::vector<Plane> frustumPlanes(const View& view) {
  std::vector<Plane> planes = wholeScreen(view).planes;
  const glm::dmat4 rows = glm::transpose(glm::dmat4(view.clip_from_world));
  planes.push_back(unitPlane(rows[3] + rows[2]));
  planes.push_back(unitPlane(rows[3] - rows[2]));
  return planes;
}

/// The cells that can see each object; none of doors that nothing shuts.
std::vector<std::vector<CellId>> cellsOfObjects(const House& house,
                                                std::span<const DoorLeaf> leaves) {
  std::vector<std::vector<CellId>> cells = house.object_cells;
  std::vector<std::uint8_t> never = doorFlags(house.object_roles);
  for (const DoorLeaf& leaf : leaves) {
    never[leaf.object] = 0;
    std::vector<CellId>& of_door = cells[leaf.object];
    const Portal& portal = house.graph.portals[leaf.portal];
    of_door.insert(of_door.end(), {portal.front, portal.back});
    std::sort(of_door.begin(), of_door.end());
    of_door.erase(std::unique(of_door.begin(), of_door.end()), of_door.end());
  }
  for (std::size_t object = 0; object < cells.size(); ++object) {
    if (never[object]) cells[object].clear();
  }
  return cells;
}

}  // namespace

ObjectIndex::ObjectIndex(const House& house)
    : leaves_(doorLeaves(house)), first_(house.graph.cells.size() + 1, 0) {
  const auto count = static_cast<std::uint32_t>(house.building.objects.size());
  assert(house.object_roles.size() == count && house.object_cells.size() == count);
  const std::vector<std::vector<CellId>> cells = cellsOfObjects(house, leaves_);
  bounds_.reserve(count);
  for (std::uint32_t object = 0; object < count; ++object) {
    bounds_.push_back(worldBounds(house.building, house.building.objects[object]));
    for (const CellId cell : cells[object]) ++first_[cell + 1];
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  cell_objects_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t object = 0; object < count; ++object) {
    for (const CellId cell : cells[object]) cell_objects_[next[cell]++] = object;
  }
  setDoors(house);
}

void ObjectIndex::setDoors(const House& house) {
  open_ = enfilade::openDoors(house, leaves_);
  drawn_.clear();
  for (std::uint32_t object = 0; object < open_.size(); ++object) {
    if (!open_[object]) drawn_.push_back(object);
  }
}

std::span<const std::uint32_t> ObjectIndex::ofCell(CellId cell) const noexcept {
  return std::span(cell_objects_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
}

void ObjectIndex::visible(const VisibleSet& set, ObjectList& list) const {
  list.seen.assign(bounds_.size(), 0);
  for (const VisibleCell& cell : set.cells) {
    for (const std::uint32_t object : ofCell(cell.cell)) {
      if (list.seen[object] || open_[object]) continue;
      list.seen[object] = std::any_of(
          cell.regions.begin(), cell.regions.end(),
          [&](const ScreenRegion& region) { return mayBeSeen(region, bounds_[object]); });
    }
  }
  list.objects.clear();
  list.objects.reserve(bounds_.size());
  for (std::uint32_t object = 0; object < list.seen.size(); ++object) {
    if (list.seen[object]) list.objects.push_back(object);
  }
}

void ObjectIndex::inFrustum(const View& view, ObjectList& list) const {
  const std::vector<Plane> planes = frustumPlanes(view);
  list.objects.clear();
  list.objects.reserve(bounds_.size());
  std::copy_if(drawn_.begin(), drawn_.end(), std::back_inserter(list.objects),
               [&](std::uint32_t object) { return mayTouch(planes, bounds_[object]); });
}

std::vector<std::uint32_t> ObjectIndex::visible(const VisibleSet& set) const {
  ObjectList list;
  visible(set, list);
  return std::move(list.objects);
}

std::vector<std::uint32_t> ObjectIndex::inFrustum(const View& view) const {
  ObjectList list;
  inFrustum(view, list);
  return std::move(list.objects);
}

}  // namespace enfilade
