#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace enfilade {

/// The entries of the folder of a house.
const std::set<std::string>& houseEntries();

/// The entries of the folder of one that is unfinished.
const std::set<std::string>& unfinishedEntries();

/// Whether a house, or what an interrupted run made of one, stands in `folder`, by what its files
/// say: others' files may bear the same names.  A file that a power cut left empty counts.
bool holdsHouse(const std::string& folder);

/// Throws Error (kUsage) if `folder` holds anything but `own` and what was half written of it, or
/// if what it has of images/, sides/, unfinished/ and replaced/ holds what is not of a house.
void refuseOtherThings(const std::string& folder, const std::set<std::string>& own);

/// Whether `entry` is a file of the name of one of `own` that was still being written.
bool isHalfWritten(const std::filesystem::directory_entry& entry, const std::set<std::string>& own);

}  // namespace enfilade
