// SPDX-License-Identifier: MIT
// What the program does with files that are wrong or meant to harm: one line that says what, soon, and
// without taking the machine's memory.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>

#include "tests/scenarios/run_program.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;
using testing::write_file;

// Far above what it takes (milliseconds), far below what a user calls a hang; the machine may be busy.
constexpr std::chrono::seconds kSoon{30};
// The program alone takes some 20 MB, under sanitizers a few times as much.
constexpr long kMostMemory_kib = 600L * 1024;

class BadInputTest : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    return write_file(folder_ / name, text).string();
  }

  void expect_refused(const std::string& file, const std::string& words) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = run_program({"validate", file});
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_EQ(outcome.out, "") << words;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err << " expected: " << words;
    EXPECT_LT(outcome.err.size(), 1000u) << words;
    EXPECT_LT(std::chrono::steady_clock::now() - start, kSoon) << words;
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    EXPECT_LT(usage.ru_maxrss, kMostMemory_kib) << words;
  }

  void expect_world_refused(const std::string& rest, const std::string& words) {
    expect_refused(write("bad.yaml", testing::kHead + rest), words);
  }

  testing::TemporaryFolder folder_;
};

TEST_F(BadInputTest, ShapesThatOverlapAreInvertedOrNotFinite) {
  expect_world_refused(
      "world:\n  - {id: a, box: {at: [3, 0, 0], size: [2, 2]}}\n"
      "  - {id: b, cylinder: {at: [3, 0], r: 0.5}}\n",
      "bad.yaml:6:5: solid 'b': lies wholly within solid 'a'");
  expect_world_refused(
      "world: [{id: a, cylinder: {at: [3, 0], r: 1}}, {id: b, cylinder: {at: [3, 0], r: 1}}]\n",
      "lies wholly within");
  expect_world_refused("world: [{id: a, polygon: [[1, 1], [1, 2], [2, 2]]}]\n", "convex, counter-clockwise");
  expect_world_refused("world: [{id: a, box: {at: [3, 0, 0], size: [-1, 2]}}]\n", "value -1 is out of range");
  expect_world_refused("world: [{id: a, bottom: 2, top: 1, cylinder: {at: [3, 0], r: 1}}]\n",
                       "must be above the bottom");
  for (const char* number :
       {"nan", ".nan", "inf", ".inf", "1e999", "1/0", "0/0", "sqrt(-1)", "tan(90)*1e300*1e300"}) {
    expect_world_refused(std::string("world: [{id: a, cylinder: {at: [3, 0], r: ") + number + "}}]\n",
                         "bad.yaml:4:");
  }
}

TEST_F(BadInputTest, ActorsThatCannotBe) {
  const std::string walker = "actors: [{id: a, use: walker, path: {line: [[3, 0], [9, 0]]}";
  expect_world_refused(walker + ", tows: {id: c, cylinder: {r: 0.2}, rope: 0}}]\n",
                       "rope: value 0 is out of range");
  expect_world_refused(walker + "}]\nworld: [{id: w, walls: [[3, -1], [3, 1]]}]\n",
                       "walker 'a': start of its path");
  expect_world_refused(walker + "}]\nworld: [{id: w, box: {at: [3, 0, 0], size: [1, 1]}}]\n",
                       "walker 'a': start of its path");
  expect_world_refused("robot: {pose: [3, 0, 0]}\nworld: [{id: w, box: {at: [3, 0, 0], size: [1, 1]}}]\n",
                       "robot: start: distance to solid 'w'");
  expect_world_refused(
      "robot: {pose: [30, 0, 0]}\nworld: [{id: w, walls: [[0, 0], [9, 0], [9, 9], [0, 9]], "
      "closed: true}, {id: c, cylinder: {at: [3, 3], r: 1}}]\n",
      "robot: start: is outside solid 'w'");
}

TEST_F(BadInputTest, TimesThatCannotBe) {
  expect_refused(write("bad.yaml", "schema: 1\nname: a\nduration: 0\n"), "bad.yaml:3:11: duration: value 0");
  expect_refused(write("bad.yaml", "schema: 1\nname: a\nduration: 1e9\n"), "duration: value 1000000000");
}

TEST_F(BadInputTest, DrivePlansThatCannotBe) {
  expect_world_refused("robot: {drive: [{path: {line: []}}]}\n", "expected at least 1 points, found 0");
  expect_world_refused("robot: {drive: [{path: {line: [[1, 1], [1, 1]]}}]}\n",
                       "robot: drive step 0: path: point 1");
  expect_world_refused("robot: {drive: [{path: {loop: [[1, 1], [2, 1]], rounds: 1e9}}]}\n", "rounds: value");
  expect_world_refused("robot: {drive: [{follow: {distance: 0}}]}\n", "distance: value 0");
}

TEST_F(BadInputTest, IncludesWithoutEnd) {
  write("a.yaml", "include: b.yaml\n");
  write("b.yaml", "include: a.yaml\n");
  expect_refused(write("bad.yaml", "include: a.yaml\n"), "'a.yaml' includes itself");
  std::string names;
  for (int i = 0; i < 1000; ++i) {
    write("p" + std::to_string(i) + ".yaml", "seed: 1\n");
    names += (i == 0 ? "p" : ", p") + std::to_string(i) + ".yaml";
  }
  expect_refused(write("bad.yaml", "include: [" + names + "]\n"), "too many includes; allowed: 32 files");
}

TEST_F(BadInputTest, Bombs) {
  std::string aliases = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    aliases += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last;
    for (int k = 0; k < 9; ++k) aliases += ", " + last;
    aliases += "]\n";
  }
  expect_refused(write("bad.yaml", aliases), "too many values; allowed: 20000, aliases expanded");
  expect_refused(write("bad.yaml", std::string(100'000, '[')), "nested too deeply");
  expect_refused(write("bad.yaml", std::string(100'000, '{')), "nested too deeply");
  const std::string large = write("large.yaml", "schema: 1\n");
  std::filesystem::resize_file(large, 100'000'000);
  expect_refused(large, "file is too large; allowed: 256 KiB");
  expect_refused("/dev/zero", "file is too large");
}

TEST_F(BadInputTest, MapsThatAreWrongOrTooLarge) {
  const auto expect_map_refused = [&](const std::string& image, const std::string& words) {
    write("m.pgm", image);
    write("m.yaml",
          "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\noccupied_thresh: 0.65\n"
          "free_thresh: 0.2\nnegate: 0\n");
    expect_world_refused("world: [{id: m, map: m.yaml}]\n", words);
  };
  expect_map_refused("", "no image that can be read");
  expect_map_refused("P5 100000 100000 255\n", "the image is too large");
  expect_map_refused("P5 4000 4000 255\n", "the file is cut off");
  // Every other pixel is a wall of its own, as many as fit.
  std::string pixels(std::size_t{4096} * 4096, '\xff');
  for (std::size_t y = 0; y < 4096; y += 2) {
    for (std::size_t x = 0; x < 4096; x += 2) pixels[4096 * y + x] = '\0';
  }
  expect_map_refused("P5 4096 4096 255\n" + pixels, "more than 10000 walls");
  write("m.pgm", "P5 2 1 255\n");
  std::filesystem::resize_file(folder_ / "m.pgm", 100'000'000);
  expect_world_refused("world: [{id: m, map: m.yaml}]\n", "file is too large; allowed: 65536 KiB");
}

}  // namespace
}  // namespace scanbed::scenarios
