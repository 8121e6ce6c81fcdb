// Keys, mouse and controller: what they stand for.
#include <gtest/gtest.h>

#include <set>

#include "app/view/cell_chooser.h"
#include "app/view/controls.h"

namespace enfilade {
namespace {

using Kind = WindowEvent::Kind;

WindowEvent keyEvent(Kind kind, Key key, bool shift = false, bool control = false) {
  WindowEvent event;
  event.kind = kind;
  event.key = event.place = key;
  event.shift = shift;
  event.control = control;
  return event;
}
WindowEvent down(Key key) { return keyEvent(Kind::kKeyDown, key); }

TEST(ViewActions, EveryLineOfTheHelpIsWhatItsKeyDoes) {
  for (const Binding& binding : bindings()) {
    if (!binding.command || binding.key == 0) continue;
    const WindowEvent event = keyEvent(Kind::kKeyDown, binding.key, binding.shift, binding.control);
    EXPECT_EQ(commandOf(event), binding.command) << binding.keys;
  }
}

TEST(ViewActions, NoTwoLinesHaveTheSameKey) {
  std::set<std::tuple<Key, bool, bool>> keys;
  for (const Binding& binding : bindings()) {
    if (binding.key == 0) continue;
    EXPECT_TRUE(keys.insert({binding.key, binding.shift, binding.control}).second) << binding.keys;
  }
}

TEST(ViewActions, NoKeyOfWalkingIsACommand) {
  for (const Key key : {Key{'W'}, Key{'A'}, Key{'S'}, Key{'D'}, Key{'E'}, Key{'Q'}, key::kUp,
                        key::kDown, key::kLeft, key::kRight, key::kLeftShift}) {
    EXPECT_FALSE(commandOf(down(key))) << keyName(key);
  }
}

TEST(ViewActions, DigitsAreMethodsAndWithShiftThoseOfTheRight) {
  EXPECT_EQ(commandOf(down('7')), (Command{Action::kMethod, 7}));
  EXPECT_EQ(commandOf(keyEvent(Kind::kKeyDown, '1', true)), (Command{Action::kSplitMethod, 1}));
  EXPECT_FALSE(commandOf(down('8')));
  EXPECT_FALSE(commandOf(down('0')));
}

TEST(Controls, AHeldKeyWalksUntilItIsLetGo) {
  Controls controls;
  controls.take(down('W'), false);
  EXPECT_EQ(controls.steer(0.1f, 0).stride.forward, 1);
  EXPECT_EQ(controls.steer(0.1f, 0).stride.forward, 1);
  controls.take(keyEvent(Kind::kKeyUp, 'W'), false);
  EXPECT_FALSE(controls.steer(0.1f, 0).any());
}

TEST(Controls, ATapBetweenTwoFramesCountsForOne) {
  Controls controls;
  controls.take(down('D'), false);
  controls.take(keyEvent(Kind::kKeyUp, 'D'), false);
  EXPECT_EQ(controls.steer(0.3f, 0).stride.right, 1);
  EXPECT_FALSE(controls.steer(0.3f, 0).any());
}

TEST(Controls, OppositeKeysCancel) {
  Controls controls;
  controls.take(down('W'), false);
  controls.take(down(key::kDown), false);
  EXPECT_EQ(controls.steer(0.1f, 0).stride.forward, 0);
}

TEST(Controls, AKeyThatIsACommandWithControlIsNotHeld) {
  Controls controls;
  controls.take(keyEvent(Kind::kKeyDown, 'Q', false, true), false);
  EXPECT_FALSE(controls.steer(0.1f, 0).any());
}

TEST(Controls, WhatIsHeldIsLetGoWithTheFocus) {
  Controls controls;
  controls.take(down('W'), false);
  controls.take(keyEvent(Kind::kFocusLost, 0), false);
  EXPECT_FALSE(controls.steer(0.1f, 0).any());
}

TEST(Controls, TheMouseTurnsOnlyWhileItIsHeldHoweverSlowTheFrame) {
  WindowEvent move;
  move.kind = Kind::kMouseMove;
  move.at = {10, -4};
  Controls controls;
  controls.take(move, false);
  EXPECT_FALSE(controls.steer(0.1f, 0.01f).any());
  controls.take(move, true);
  controls.take(move, true);
  const Steering steering = controls.steer(0.5f, 0.01f);
  EXPECT_FLOAT_EQ(steering.yaw, -0.2f);
  EXPECT_FLOAT_EQ(steering.pitch, 0.08f);
}

TEST(Controls, AControllersButtonsActOnceAndItsSticksSteer) {
  Controls controls;
  GamepadState pad;
  pad.there = pad.a = true;
  pad.left = {0.5f, -1};
  std::vector<Command> commands;
  controls.take(pad, commands);
  controls.take(pad, commands);
  EXPECT_EQ(commands, (std::vector<Command>{{Action::kDoor, 0}}));
  const Steering steering = controls.steer(0.1f, 0);
  EXPECT_FLOAT_EQ(steering.stride.forward, 1);
  EXPECT_FLOAT_EQ(steering.stride.right, 0.5f);
}

class CellChooserTest : public ::testing::Test {
 protected:
  CellChooserTest() : chooser_(graph_) { chooser_.open(); }

  static CellGraph rooms() {
    CellGraph graph;
    graph.storeys = {{"ground", 0}};
    for (const char* name : {"exterior", "Kitchen", "hall", "küche", "kit store"}) {
      Cell cell;
      cell.name = name;
      graph.cells.push_back(cell);
    }
    return graph;
  }
  void type(const std::u32string& text) {
    for (const char32_t c : text) {
      chooser_.take(down('K'));
      WindowEvent event;
      event.kind = Kind::kText;
      event.character = c;
      chooser_.take(event);
    }
  }

  CellGraph graph_ = rooms();
  CellChooser chooser_;
};

TEST_F(CellChooserTest, OffersTheCellsWhoseNameHoldsWhatWasTyped) {
  EXPECT_EQ(chooser_.offered().size(), 5u);
  type(U"KIT");
  EXPECT_EQ(chooser_.offered(), (std::vector<CellId>{1, 4}));
  type(U" s");
  EXPECT_EQ(chooser_.offered(), (std::vector<CellId>{4}));
  type(U"zz");
  EXPECT_TRUE(chooser_.offered().empty());
  EXPECT_FALSE(chooser_.take(down(key::kEnter))) << "there is nothing to choose";
}

TEST_F(CellChooserTest, TheLetterThatOpenedItIsNotTyped) {
  WindowEvent letter;
  letter.kind = Kind::kText;
  letter.character = U'j';
  chooser_.take(letter);
  EXPECT_EQ(chooser_.offered().size(), 5u);
}

TEST_F(CellChooserTest, LettersBeyondAsciiAreTakenBackWhole) {
  type(U"kü");
  EXPECT_EQ(chooser_.offered(), (std::vector<CellId>{3}));
  chooser_.take(down(key::kBackspace));
  EXPECT_EQ(chooser_.offered(), (std::vector<CellId>{1, 3, 4}));
}

TEST_F(CellChooserTest, ArrowsChooseAndEnterGoesThere) {
  type(U"k");
  chooser_.take(down(key::kUp));
  chooser_.take(down(key::kDown));
  EXPECT_EQ(chooser_.take(down(key::kEnter)), std::optional<CellId>(3));
  EXPECT_FALSE(chooser_.isOpen());
}

TEST_F(CellChooserTest, EscapeGoesNowhere) {
  EXPECT_FALSE(chooser_.take(down(key::kEscape)));
  EXPECT_FALSE(chooser_.isOpen());
}

}  // namespace
}  // namespace enfilade
