#pragma once

#include <functional>
#include <optional>
#include <string>

#include "portals/house.h"
#include "preprocess/preprocess_job.h"

namespace enfilade {

/// A house in the making, in the folder `unfinished` of its own folder, so that an older house
/// there stays whole until the new one takes its place.  It holds
///
///     job.json                              what is made of what: only the same job goes on
///     cells.grid, geometry.glb, house.json  a house without images; house.json stands last
///     images/portal-PPPP-front, -back       the portal sides, see SideFolder
///     sides/portal-PPPP-front, -back        records of those that are finished
///     finished.json                         the house.json to be: all is there but the moving
///     replaced/                             the older house, while the new one is moved
///
/// Nothing stands under its name before it is whole, so that it can be gone on with whenever it was
/// stopped.
class UnfinishedHouse {
 public:
  UnfinishedHouse(std::string house_folder, PreprocessJob job);
  ~UnfinishedHouse();  ///< removes what is not worth keeping: work without a house
  UnfinishedHouse(const UnfinishedHouse&) = delete;
  UnfinishedHouse& operator=(const UnfinishedHouse&) = delete;

  /// The house, without images, that an interrupted run of the same job left; of another job
  /// nothing, and `note` is told why.  Throws Error (kUsage) if there are other things.
  std::optional<House> takeUp(const std::function<void(const std::string&)>& note);

  /// The house of an interrupted run that had only to put it in its place, or had just done so; it
  /// now is there.
  std::optional<House> takeUpFinished();

  /// Writes `house` without images and reads it back, so that what is baked does not depend on who
  /// found the cells, this run or an earlier one.  Throws Error (kMachine).
  House write(const House& house);

  /// Puts the house, complete with `house.files`, in the place of what was there.  Throws Error
  /// (kMachine).
  void finish(const House& house);

  const std::string& path() const noexcept { return path_; }

 private:
  bool isOfThisJob() const;
  bool isInPlace() const;  ///< its run was stopped after the last move
  void moveIntoPlace();
  void tidyUp();

  std::string house_folder_;
  std::string path_;
  PreprocessJob job_;
  bool ours_ = false;  ///< the folder is proved to hold nothing else
};

/// What of the house in `folder` an interrupted run has finished, for a person; empty if nothing.
std::string describeUnfinished(const std::string& folder);

/// What to do about it, to be said after it.
inline constexpr const char* kHowToGoOn = ": the same command goes on from there";

}  // namespace enfilade
