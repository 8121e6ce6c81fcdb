#include "portals/house.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <span>
#include <string>

#include "portals/house_json.h"
#include "portals/json_text.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "test_house.h"

namespace enfilade {
namespace {

using testing::smallHouse;
using testing::TemporaryFolder;

std::string textOf(const std::string& file) {
  const auto bytes = readFile(file);
  return {bytes.begin(), bytes.end()};
}

void replaceText(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), by);
}

/// Mends the checksum at the end of an edited house.json, as a malicious file would.
void mendChecksum(std::string& text) {
  const std::size_t at = text.rfind('"') - 16;
  text.replace(at, 16, ownChecksum(text, at));
}

/// What the reader says of a folder; empty if it takes it.
std::string complaint(const std::string& folder) {
  try {
    readHouse(folder);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(std::string(error.what()).find(folder), 0u) << error.what();
    return error.what();
  }
}

/// A written house whose house.json is edited, with the right checksum.
std::string complaintOnEdit(const std::string& what, const std::string& by) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "house";
  writeHouse(folder, smallHouse());
  std::string text = textOf(houseJsonFile(folder));
  replaceText(text, what, by);
  mendChecksum(text);
  writeFileAtomically(houseJsonFile(folder), text);
  return complaint(folder);
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(HouseFile, GivesBackWhatWasWritten) {
  const TemporaryFolder temporary;
  const House written = smallHouse();
  writeHouse(temporary / "a/house", written);
  EXPECT_TRUE(isHouse(temporary / "a/house"));
  const House read = readHouse(temporary / "a/house");
  EXPECT_EQ(read.info.tool_version, written.info.tool_version);
  EXPECT_EQ(read.info.model_name, written.info.model_name);
  EXPECT_EQ(read.info.model_sha256, written.info.model_sha256);
  EXPECT_EQ(read.info.parameters, written.info.parameters);
  EXPECT_EQ(read.info.statistics, written.info.statistics);
  EXPECT_EQ(read.info.log, written.info.log);
  ASSERT_EQ(read.info.leaks.size(), 1u);
  EXPECT_EQ(read.info.leaks[0].room, "porch");
  EXPECT_EQ(read.info.leaks[0].into, "exterior");
  EXPECT_EQ(read.info.leaks[0].path, written.info.leaks[0].path);
  EXPECT_EQ(read.info.leaks[0].place, written.info.leaks[0].place);
  EXPECT_EQ(read.object_roles, written.object_roles);
  EXPECT_EQ(read.object_cells, written.object_cells);
  EXPECT_EQ(read.switch_distance, written.switch_distance);
  EXPECT_EQ(read.eye_height, written.eye_height);
  EXPECT_TRUE(std::ranges::equal(read.grid.runs(), written.grid.runs()));
  ASSERT_EQ(read.graph.storeys.size(), 2u);
  EXPECT_EQ(read.graph.storeys[1].name, "upper");
  EXPECT_EQ(read.graph.storeys[1].floor_y, 2.7f);
  ASSERT_EQ(read.graph.cells.size(), 3u);
  EXPECT_TRUE(read.graph.cells[0].bounds.empty());
  EXPECT_EQ(read.graph.cells[2].bounds.max, written.graph.cells[2].bounds.max);
  EXPECT_EQ(read.graph.cells[2].name, "hall");
  EXPECT_EQ(read.graph.cells[2].storey, 1);
  EXPECT_EQ(read.graph.cells[2].volume, 14.5f);
  EXPECT_EQ(read.graph.cells[2].floor_area, 6.1f);
  EXPECT_EQ(read.graph.cells[1].portals, written.graph.cells[1].portals);
  ASSERT_EQ(read.graph.portals.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Portal& a = read.graph.portals[i];
    const Portal& b = written.graph.portals[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.polygon, b.polygon);
    EXPECT_EQ(a.plane.normal, b.plane.normal);
    EXPECT_EQ(a.plane.d, b.plane.d);
    EXPECT_EQ(a.front, b.front);
    EXPECT_EQ(a.back, b.back);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.two_way, b.two_way);
    EXPECT_EQ(a.active, b.active);
  }
  ASSERT_EQ(read.building.objects.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Object& object = read.building.objects[i];
    EXPECT_EQ(read.building.nodes[object.node].name, "node " + std::to_string(i));
    EXPECT_EQ(worldBounds(read.building, object).min,
              worldBounds(written.building, written.building.objects[i]).min);
  }
}

TEST(HouseFile, IsTheSameBytesEachTime) {
  const TemporaryFolder temporary;
  writeHouse(temporary / "a", smallHouse());
  writeHouse(temporary / "b", readHouse(temporary / "a"));
  for (const auto file : {houseJsonFile, geometryFile, cellGridFile}) {
    EXPECT_EQ(readFile(file(temporary / "a")), readFile(file(temporary / "b")));
  }
}

TEST(HouseFile, NumbersReadWellAndKeepEveryFloat) {
  EXPECT_EQ(shortDecimal(0.1f), 0.1);
  EXPECT_EQ(shortDecimal(1.55f), 1.55);
  std::mt19937 random(1);
  for (int i = 0; i < 200000; ++i) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(static_cast<float>(shortDecimal(value)), value);
  }
  const TemporaryFolder temporary;
  writeHouse(temporary / "a", smallHouse());
  const std::string text = textOf(houseJsonFile(temporary / "a"));
  EXPECT_SAYS(text, "\"eye_height\": 1.55,\n");
  EXPECT_SAYS(text,
              "\"polygon\": [[2.0, 0.0, 2.0], [2.0, 0.0, 1.1], [2.0, 2.1, 1.1], [2.0, 2.1, 2.0]]");
}

TEST(HouseFile, RejectsWhatIsNoHouse) {
  const TemporaryFolder temporary;
  EXPECT_SAYS(complaint(temporary / "nothing"), "no such file");
  writeFileAtomically(temporary / "file", std::string("text"));
  EXPECT_SAYS(complaint(temporary / "file"), "not a house folder");
  createFolders(temporary / "empty");
  EXPECT_SAYS(complaint(temporary / "empty"), "no house.json");
  createFolders(unfinishedFolder(temporary / "half"));
  EXPECT_SAYS(complaint(temporary / "half"), "not yet finished: let its 'enfilade preprocess'");
  EXPECT_FALSE(isHouse(temporary / "empty"));
  writeFileAtomically(temporary / "empty/house.json", std::string("{\"enfilade\": \"tour\"}"));
  EXPECT_SAYS(complaint(temporary / "empty"), "not describe a house");
  writeFileAtomically(temporary / "empty/house.json", std::string("[1, 2"));
  EXPECT_SAYS(complaint(temporary / "empty"), "not JSON");
  writeFileAtomically(temporary / "empty/house.json", std::string(1000000, '['));
  EXPECT_SAYS(complaint(temporary / "empty"), "nests its JSON deeper than 100");
  writeFileAtomically(temporary / "empty/house.json",
                      std::string(300000, '[') + std::string(300000, ']'));
  EXPECT_SAYS(complaint(temporary / "empty"), "nests its JSON deeper than 100");
}

TEST(HouseFile, RejectsAnotherFormatVersionAndSaysWhatToDo) {
  EXPECT_SAYS(complaintOnEdit("\"format\": 2", "\"format\": 7"),
              "house.json: is of format version 7, newer than version 2 that this program reads: "
              "use a newer enfilade, or preprocess the model again");
  EXPECT_SAYS(complaintOnEdit("\"format\": 2", "\"format\": 1"),
              "house.json: is of format version 1, older than version 2 that this program reads: "
              "preprocess the model again");
}

TEST(HouseFile, ListsItsImagesAndProvesThem) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "house";
  House written = smallHouse();
  const std::string name = portalImageName(0, true, "ldi.bin");
  written.files[name] = fileChecksum(std::vector<std::uint8_t>{1, 2, 3});
  writeHouse(folder, written);
  const House read = readHouse(folder);
  EXPECT_EQ(read.files.size(), 3u);
  EXPECT_TRUE(hasFile(read, name));
  const auto complaintOnImage = [&](const std::string& image) -> std::string {
    try {
      readHouseFile(read, folder, image);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      return error.what();
    }
    return "";
  };
  const std::string file = portalImageFolder(folder, 0, true) + "/ldi.bin";
  EXPECT_EQ(complaintOnImage(name),
            file + ": is missing, and house.json lists it; preprocess the model again");
  createFolders(portalImageFolder(folder, 0, true));
  writeFileAtomically(file, std::vector<std::uint8_t>{1, 2, 3});
  EXPECT_EQ(complaintOnImage(name), "");
  writeFileAtomically(file, std::vector<std::uint8_t>{1, 2, 4});
  EXPECT_SAYS(complaintOnImage(name),
              file + ": is cut short, damaged, or of another house or portal");
  EXPECT_SAYS(complaintOnImage(portalImageName(0, false, "ldi.bin")), "is none of the files");
}

TEST(HouseFile, RejectsAFlippedByteInAnyOfItsFiles) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "house";
  writeHouse(folder, smallHouse());
  ASSERT_EQ(complaint(folder), "");
  for (const std::string& file :
       {houseJsonFile(folder), geometryFile(folder), cellGridFile(folder)}) {
    const auto good = readFile(file);
    for (std::size_t at = 0; at < good.size(); at += good.size() / 41 + 1) {
      for (const int flip : {1, 128}) {
        auto bytes = good;
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ flip);
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
        ASSERT_NE(complaint(folder), "") << file << " byte " << at;
      }
    }
    writeFileAtomically(file, good);
  }
  ASSERT_EQ(complaint(folder), "");
}

TEST(HouseFile, RejectsATruncatedFileAndAMissingOne) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "house";
  writeHouse(folder, smallHouse());
  for (const std::string& file :
       {houseJsonFile(folder), geometryFile(folder), cellGridFile(folder)}) {
    const auto good = readFile(file);
    for (const std::size_t size : {std::size_t{0}, good.size() / 2, good.size() - 1}) {
      writeFileAtomically(file, std::span(good).first(size));
      EXPECT_NE(complaint(folder), "") << file << " of " << size << " bytes";
    }
    std::filesystem::remove(file);
    EXPECT_NE(complaint(folder), "") << "without " << file;
    writeFileAtomically(file, good);
  }
}

TEST(HouseFile, RejectsFilesOfAnotherHouse) {
  const TemporaryFolder temporary;
  House other = smallHouse();
  other.building.nodes[2].name = "moved";
  writeHouse(temporary / "a", smallHouse());
  writeHouse(temporary / "b", other);
  std::filesystem::copy_file(geometryFile(temporary / "b"), geometryFile(temporary / "a"),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_SAYS(complaint(temporary / "a"), "of another house");
}

TEST(HouseFile, RejectsValuesOutOfRangeAndNamesThem) {
  EXPECT_SAYS(complaintOnEdit("\"front\": 2", "\"front\": 3"), "portals[0].front");
  EXPECT_SAYS(complaintOnEdit("\"front\": 2", "\"front\": -1"), "portals[0].front");
  EXPECT_SAYS(complaintOnEdit("\"front\": 2", "\"front\": 1"), "same cell");
  EXPECT_SAYS(complaintOnEdit("\"front\": 2", "\"front\": 1e30"), "whole number");
  EXPECT_SAYS(complaintOnEdit("\"kind\": \"door\"", "\"kind\": \"cat flap\""), "cat flap");
  EXPECT_SAYS(complaintOnEdit("[2.0, 0.0, 1.1]", "[2.0,1e300,1.1]"),
              "polygon[1][1] is out of range");
  EXPECT_SAYS(complaintOnEdit("[2.0, 0.0, 1.1]", "[2.0,\"x\",1.1]"),
              "polygon[1][1] is not a number");
  EXPECT_SAYS(complaintOnEdit("[2.0, 0.0, 1.1]", "[2.0,1.1]"), "polygon[1]");
  EXPECT_SAYS(complaintOnEdit("\"storey\": 1", "\"storey\": 2"), "cells[2].storey");
  EXPECT_SAYS(
      complaintOnEdit("\"cell_set_of_object\": [0, 1, 0]", "\"cell_set_of_object\": [0, 2, 0]"),
      "cell_set_of_object[1]");
  EXPECT_SAYS(
      complaintOnEdit("\"cell_set_of_object\": [0, 1, 0]", "\"cell_set_of_object\": [0, 1]"),
      "objects");
  EXPECT_SAYS(complaintOnEdit("\"cell_sets\": [[1, 2]", "\"cell_sets\": [[2, 1]"), "increase");
  EXPECT_SAYS(complaintOnEdit("\"door\": [1]", "\"door\": [3]"), "roles.door[0]");
  EXPECT_SAYS(complaintOnEdit("\"eye_height\": 1.55", "\"eye_height\": 0"), "eye_height");
  EXPECT_SAYS(complaintOnEdit("\"eye_height\"", "\"eye_hight\""), "eye_height is missing");
  EXPECT_SAYS(complaintOnEdit("\"active\": true", "\"active\": 1"), "portals[0].active");
}

TEST(HouseFile, RejectsMoreCellsOfObjectsThanMemoryHolds) {
  std::string objects = "[0";
  for (int i = 1; i < 40'000; ++i) objects += ",0";
  std::string cell_set = "[0";
  for (int i = 1; i < 2000; ++i) cell_set += "," + std::to_string(i);
  std::string more_cells;
  for (int i = 3; i < 2000; ++i) {
    more_cells += R"({"name": "c", "storey": 0, "bounds": null, "volume": 0, "floor_area": 0},)";
  }
  std::string text = encodeHouseJson(smallHouse(), {});
  replaceText(text, "\"cells\": [", "\"cells\": [" + more_cells);
  replaceText(text, "\"cell_sets\": [[1, 2]", "\"cell_sets\": [" + cell_set + "]");
  replaceText(text, "\"cell_set_of_object\": [0, 1, 0]",
              "\"cell_set_of_object\": " + objects + "]");
  mendChecksum(text);
  House house;
  try {
    decodeHouseJson(text, "house.json", house);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_SAYS(std::string(error.what()),
                "cell_set_of_object names too many cells for too many objects");
  }
}

TEST(HouseFile, RejectsVoxelsOfACellThatThereIsNot) {
  House house = smallHouse();
  house.graph.cells.pop_back();
  house.graph.portals[0].front = kExterior;
  house.object_cells = {{1}, {}, {1}};
  const TemporaryFolder temporary;
  writeHouse(temporary / "house", house);
  EXPECT_SAYS(complaint(temporary / "house"), "voxels of a cell");
}

TEST(HouseFile, OverwritingLeavesNoHouseUntilTheNewOneIsWhole) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "house";
  writeHouse(folder, smallHouse());
  // geometry.glb cannot be replaced: a folder stands in its place.
  std::filesystem::remove(geometryFile(folder));
  createFolders(geometryFile(folder) + "/in the way");
  try {
    writeHouse(folder, smallHouse());
    FAIL() << "wrote over a folder";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kMachine);
    EXPECT_SAYS(std::string(error.what()), "geometry.glb");
  }
  EXPECT_FALSE(isHouse(folder));
}

TEST(HouseFile, NamesPortalImagesBySide) {
  EXPECT_EQ(portalImageFolder("h", 7, true), "h/images/portal-0007-front");
  EXPECT_EQ(portalImageFolder("h", 12345, false), "h/images/portal-12345-back");
}

}  // namespace
}  // namespace enfilade
