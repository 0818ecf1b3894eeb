// SPDX-License-Identifier: MIT
#include "scenarios/run/truth_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/scan/laser_scan.hpp"
#include "scenarios/run/output.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

Truth some_truth(int seed) {
  Truth truth;
  truth.X_WS = {{1.5, -2.0 + seed}, 0.25};
  truth.beams = {{.object = 1, .range_m = 2.125, .incidence_rad = 0.5, .mixed = true},
                 {.object = kNoObject, .range_m = kNoEcho},
                 {.object = kNoObject, .range_m = kNoEcho},
                 {.object = 0, .range_m = 2.0}};
  ObjectTruth wall;
  wall.id = "hall.2";
  wall.label = "wall";
  wall.primitive = Primitive::kLine;
  wall.from_m = {1.0, 2.0};
  wall.to_m = {-3.0, 4.0};
  ObjectTruth leg;
  leg.id = "a.left_leg";
  leg.primitive = Primitive::kLeg;
  leg.center_m = {0.1 + seed, 0.2};
  leg.radius_m = 0.07;
  leg.num_clean_beams = 9;
  leg.visibility = Visibility::kResolvable;
  truth.objects = {wall, leg};
  return truth;
}

std::vector<double> ranges(int seed) {
  return {1.0 + seed, kNoEcho, kInvalid, 2.0};
}

// As an emulator writes it, for scans 0, 1, ...
std::filesystem::path written(const testing::TemporaryFolder& folder, int num_scans) {
  TruthWriter writer(folder / "truth.jsonl");
  writer.begin();
  for (int i = 0; i < num_scans; ++i) writer.write(i, ranges(i), some_truth(i));
  return folder / "truth.jsonl";
}

TEST(TruthFileTest, TruthComesBackWhole) {
  const testing::TemporaryFolder folder;
  TruthReader reader(written(folder, 1));
  const Truth* const read = reader.find(ranges(0));
  ASSERT_NE(read, nullptr);
  const Truth sent = some_truth(0);
  EXPECT_EQ(read->X_WS.p_m, sent.X_WS.p_m);
  EXPECT_EQ(read->X_WS.theta_rad, 0.25);
  ASSERT_EQ(read->beams.size(), 4u);
  EXPECT_EQ(read->beams[0].object, 1);
  EXPECT_EQ(read->beams[0].range_m, 2.125);
  EXPECT_TRUE(read->beams[0].mixed);
  EXPECT_EQ(read->beams[1].range_m, kNoEcho);
  ASSERT_EQ(read->objects.size(), 2u);
  EXPECT_EQ(read->objects[0].to_m, sent.objects[0].to_m);
  EXPECT_EQ(read->objects[0].visibility, Visibility::kHidden);
  EXPECT_EQ(read->objects[1].id, "a.left_leg");
  EXPECT_EQ(read->objects[1].primitive, Primitive::kLeg);
  EXPECT_EQ(read->objects[1].radius_m, 0.07);
  EXPECT_EQ(read->objects[1].num_clean_beams, 9);
}

// What a file says of its only line, with a part of it replaced.
std::string refusal(const std::string& from, const std::string& to) {
  const testing::TemporaryFolder folder;
  const std::filesystem::path file = written(folder, 1);
  std::string line = testing::read_file(file);
  line.replace(line.find(from), from.size(), to);
  testing::write_file(file, line);
  TruthReader reader(file);
  return testing::error_of([&] { reader.find(ranges(0)); });
}

TEST(TruthFileTest, RefusesLinesThatAreNone) {
  EXPECT_NE(refusal("{\"scan\":0,", "[").find("not JSON"), std::string::npos);
  EXPECT_NE(refusal("\"hash\":\"", "\"hash\":\"x").find("'hash' is no number"), std::string::npos);
  EXPECT_NE(refusal("\"hash\"", "\"cash\"").find("'hash' is missing"), std::string::npos);
  EXPECT_NE(refusal("\"truth\"", "\"lies\"").find("'truth' is missing"), std::string::npos);
  // More than there are, and more than a whole number can be.
  EXPECT_NE(refusal("\"object\":1", "\"object\":9").find("a beam's object 9 is not among the 2"),
            std::string::npos);
  EXPECT_NE(refusal("\"object\":1", "\"object\":1e300").find("object is not a whole number"),
            std::string::npos);
  const std::string no_echo = R"({"object":-1,"range":-1,"incidence":0,"mixed":0})";
  EXPECT_NE(refusal("," + no_echo, "").find("the truth has 3 beams, but the scan 4"), std::string::npos);
}

TEST(TruthFileTest, RefusesALineWithoutEnd) {
  TruthReader reader("/dev/zero");
  EXPECT_EQ(testing::error_of([&] { reader.find(ranges(0)); }),
            "--truth /dev/zero: holds a line longer than 16 MiB; allowed: what emulate wrote");
}

TEST(TruthFileTest, ScansAreToldApartByTheirRanges) {
  EXPECT_EQ(range_hash(ranges(0)), range_hash(ranges(0)));
  EXPECT_NE(range_hash(ranges(0)), range_hash(ranges(1)));
  const std::vector<double> one_way = {kInvalid};
  const std::vector<double> other_way = {-kInvalid};
  EXPECT_EQ(range_hash(one_way), range_hash(other_way));
}

TEST(TruthFileTest, FindsScansThoughSomeAreMissing) {
  const testing::TemporaryFolder folder;
  TruthReader reader(written(folder, 5));
  ASSERT_NE(reader.find(ranges(1)), nullptr);
  EXPECT_EQ(reader.find(ranges(1))->X_WS.p_m.y(), -1.0);
  EXPECT_EQ(reader.find(ranges(77)), nullptr);
  ASSERT_NE(reader.find(ranges(4)), nullptr);
  EXPECT_EQ(reader.find(ranges(4))->X_WS.p_m.y(), 2.0);
}

TEST(TruthFileTest, FollowsAFileThatGrows) {
  testing::TemporaryFolder folder;
  TruthWriter writer(folder / "truth.jsonl");
  writer.begin();
  TruthReader reader(folder / "truth.jsonl");
  EXPECT_EQ(reader.find(ranges(0)), nullptr);
  writer.write(0, ranges(0), some_truth(0));
  EXPECT_NE(reader.find(ranges(0)), nullptr);
  writer.write(1, ranges(1), some_truth(1));
  EXPECT_NE(reader.find(ranges(1)), nullptr);
}

TEST(TruthFileTest, TellsWhichFileCannotBeUsedAndWhy) {
  EXPECT_EQ(testing::error_of([] { TruthReader("/no/such/file"); }),
            "--truth /no/such/file: cannot be read: No such file or directory");
  EXPECT_EQ(testing::error_of<OutputFault>([] { TruthWriter("/no/such/file"); }),
            "--truth /no/such/file: cannot be written: No such file or directory");
}

TEST(TruthFileTest, RefusesFilesOfSomethingElse) {
  const testing::TemporaryFolder folder;
  const std::string file = testing::write_file(folder / "x", "#!/bin/sh\n");
  TruthReader reader(file);
  EXPECT_EQ(
      testing::error_of([&] { reader.find(ranges(0)); }),
      "--truth " + file +
          ": holds a line that is no truth of a scan: not JSON at byte 0: expected a value; allowed: what "
          "emulate wrote");
}

TEST(TruthFileTest, LeavesAFileAsItWasUntilItBegins) {
  const testing::TemporaryFolder folder;
  const std::string old = testing::write_file(folder / "old", "precious");
  { const TruthWriter writer(old); }
  EXPECT_EQ(std::filesystem::file_size(old), 8u);
  { const TruthWriter writer(folder / "new"); }
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  {
    TruthWriter writer(old);
    writer.begin();
    writer.write(0, ranges(0), some_truth(0));
  }
  EXPECT_NE(TruthReader(old).find(ranges(0)), nullptr);
}

TEST(TruthFileTest, TellsOfALineThatIsLost) {
  TruthWriter writer("/dev/full");
  writer.begin();
  EXPECT_EQ(testing::error_of<OutputFault>([&] { writer.write(0, ranges(0), some_truth(0)); }),
            "--truth /dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace scanbed::scenarios
