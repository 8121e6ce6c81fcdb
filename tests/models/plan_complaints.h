#pragma once

#include <gtest/gtest.h>

#include <string>

#include "models/floor_plan.h"
#include "models/raise_building.h"
#include "scene/error.h"

namespace enfilade {

/// `text` with its first `from` made `to`; `from` must be there.
inline std::string replacedIn(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The complaint about a plan, from reading it to laying it out and raising it; "none" without one.
inline std::string complaintAbout(const std::string& text, const std::string& subject) {
  try {
    raiseBuilding(parseFloorPlan(text, subject), 2000, subject);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kBadInput);
    EXPECT_TRUE(std::string(e.what()).starts_with(subject + ": ")) << e.what();
    return e.what();
  }
  return "none";
}

}  // namespace enfilade
