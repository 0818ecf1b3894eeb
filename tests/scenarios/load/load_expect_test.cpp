// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

const std::string kWorld =
    "world: [{id: hall, walls: [[-9, -9], [9, -9]]}, {id: seat, use: bench, at: [4, 4, 0], feet: {r: 0.2, "
    "apart: 1}}]\n"
    "actors: [{id: ann, use: walker, path: {line: [[5, 0], [9, 0]]}, tows: {id: cyl, cylinder: {r: 0.2}}}]\n";

Expectation expectation(const std::string& item) {
  return testing::parse(kWorld + "expect: [" + item + "]\n").expectations.at(0);
}

std::string error(const std::string& item) {
  return testing::parse_error(kWorld + "expect: [" + item + "]\n");
}

TEST(LoadExpectTest, TakesEveryKey) {
  const Expectation near = expectation(
      "{between: [0.5, 1], scans: 0.9, circle: {near: cyl, within: 0.2, at_least: 1, at_most: 2}}");
  EXPECT_EQ(near.text(), "circle, 1 to 2 within 0.2 m of cyl, in 90 % of the scans of 0.5 to 1 s");
  EXPECT_EQ(expectation("{leg: {recall: 0.5, precision: 0.6}}").text(),
            "leg, recall >= 0.5, precision >= 0.6, in all scans");
  EXPECT_EQ(expectation("{line: {}, scans: some}").text(), "line, at least 1, in one scan");
  EXPECT_EQ(expectation("{line: {at_most: 0}, scans: all}").text(), "line, at most 0, in all scans");
  EXPECT_EQ(expectation("{bench: {near: cyl, within: 0.3, at_most: 0}}").text(),
            "bench, at most 0 within 0.3 m of cyl, in all scans");
  EXPECT_EQ(expectation("{trash_can: {at_least: 2}}").text(), "trash_can, at least 2, in all scans");
  EXPECT_EQ(expectation("{line: {}, preset: paper}").preset, "paper");
  EXPECT_EQ(expectation("{line: {}, known_fail: too far}").known_fail, "too far");
}

TEST(LoadExpectTest, NamesObjectsAndThingsOfSeveral) {
  for (const char* id : {"hall", "hall.0", "seat", "seat.foot_1", "ann", "ann.left_leg", "cyl"}) {
    EXPECT_EQ(error("{line: {near: " + std::string(id) + ", within: 1}}"), "") << id;
  }
  EXPECT_EQ(error("{line: {near: hal, within: 1}}"), "f:6:24: near: no object 'hal'; did you mean 'hall'?");
  EXPECT_NE(error("{line: {near: hall.1, within: 1}}").find("no object 'hall.1'"), std::string::npos);
}

TEST(LoadExpectTest, RefusesWhatCannotBeMeant) {
  EXPECT_EQ(error("{scans: all}"),
            "f:6:10: expect: expects nothing; one of line, circle, leg, wall, corner, column, bench, door, "
            "trash_can");
  EXPECT_EQ(error("{line: {}, leg: {}}"), "f:6:26: leg: a second kind beside 'line'");
  EXPECT_EQ(error("{line: {near: hall}}"), "f:6:17: line: missing key 'within'");
  EXPECT_EQ(error("{line: {at_least: 2, at_most: 1}}"), "f:6:40: at_most: is less than at_least");
  EXPECT_EQ(error("{line: {near: hall, within: 1, recall: 1}}"),
            "f:6:17: line: near goes with at_least and at_most");
  EXPECT_EQ(
      error("{bench: {recall: 1}}"),
      "f:6:18: bench: recall and precision are of line, circle and leg; a scene's objects have at_least and "
      "at_most");
  EXPECT_EQ(error("{line: {}, scans: most}"), "f:6:28: scans: expected a number, found 'most'");
  EXPECT_EQ(error("{line: {}, between: [1, 1]}"), "f:6:34: between: the window ends before it begins");
  EXPECT_EQ(error("{line: {}, between: [1, 3]}"),
            "f:6:34: between: value 3 is out of range; allowed: [0, 2]");
  EXPECT_EQ(error("{line: {atleast: 1}}"), "f:6:18: unknown key 'atleast'; did you mean 'at_least'?");
}

}  // namespace
}  // namespace scanbed::scenarios
