// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/geometry/angles.hpp"
#include "tests/scenarios/run_program.hpp"
#include "tests/support/gzip.hpp"

namespace scanbed::scenarios {
namespace {

using testing::flaser;
using testing::Outcome;
using testing::run_program;

class DetectTest : public ::testing::Test {
 protected:
  std::string log(const std::string& text, const std::string& name = "a.log") const {
    return "log:" + testing::write_file(folder_ / name, text).string();
  }

  static std::vector<nlohmann::json> objects(const Outcome& outcome) {
    std::vector<nlohmann::json> all;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }

  testing::TemporaryFolder folder_;
};

const std::string kScan = flaser(std::vector<std::string>(181, "2.0"));

TEST_F(DetectTest, PrintsOneObjectAScanAndCountsAtTheEnd) {
  const Outcome outcome = run_program({"detect", "--laser", log("# a comment\n" + kScan + kScan)});
  EXPECT_EQ(outcome.exit_code, 0);
  ASSERT_EQ(objects(outcome).size(), 2u);
  EXPECT_EQ(objects(outcome)[1]["scan"], 1);
  EXPECT_EQ(outcome.err, "scanbed: 2 scans, 0 damaged lines, 1 other line\n");
}

TEST_F(DetectTest, SaysWhatWasFollowedAndWhatTheSceneIsWhereAsked) {
  const std::vector<std::string> plain = {"detect",  "--laser", "sim:static_hallway", "--preset", "robust",
                                          "--limit", "15"};
  std::vector<std::string> both = plain;
  both.insert(both.end(), {"--track", "--interpret"});
  const std::vector<nlohmann::json> without = objects(run_program(plain));
  const std::vector<nlohmann::json> with = objects(run_program(both));
  ASSERT_EQ(without.size(), 15u);
  ASSERT_EQ(with.size(), 15u);
  EXPECT_FALSE(without[14].contains("tracks") || without[14].contains("scene"));
  EXPECT_EQ(with[0]["tracks"].size(), 0u);  // one hit confirms nothing
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i]["features"], without[i]["features"]);
    for (const nlohmann::json& object : with[i]["scene"]) {
      for (const int from : object["from"]) {
        ASSERT_LT(from, static_cast<int>(with[i]["features"].size()));
        const bool is_round = with[i]["features"][from]["type"] == "circle";
        const bool wants_round =
            object["kind"] == "bench" || object["kind"] == "column" || object["kind"] == "trash_can";
        EXPECT_EQ(is_round, wants_round) << object;
      }
    }
  }
  const auto is_column = [](const nlohmann::json& track) { return track["kind"] == "cylinder"; };
  EXPECT_GE(std::count_if(with[14]["tracks"].begin(), with[14]["tracks"].end(), is_column), 2);
  const auto is_bench = [](const nlohmann::json& object) { return object["kind"] == "bench"; };
  EXPECT_EQ(std::count_if(with[14]["scene"].begin(), with[14]["scene"].end(), is_bench), 2);
}

TEST_F(DetectTest, ReadsTheRecordedHall) {
  const std::string path = SCANBED_SOURCE_DIR "/../shared/data/columns_hall.log";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Outcome outcome = run_program({"detect", "--laser", "log:" + path});
  EXPECT_EQ(outcome.exit_code, 0);
  const std::vector<nlohmann::json> scans = objects(outcome);
  ASSERT_EQ(scans.size(), 37u);
  std::size_t num_circles = 0;
  for (const nlohmann::json& scan : scans) {
    for (const nlohmann::json& feature : scan["features"]) num_circles += feature["type"] == "circle" ? 1 : 0;
  }
  EXPECT_GT(num_circles, 0u);
}

TEST_F(DetectTest, AnswersWithNothingWhereAScanHoldsNothing) {
  for (const std::size_t num_beams : {1u, 2u}) {
    const Outcome outcome =
        run_program({"detect", "--laser", log(flaser(std::vector<std::string>(num_beams, "2.0")))});
    EXPECT_EQ(outcome.exit_code, 0) << num_beams << outcome.err;
    ASSERT_EQ(objects(outcome).size(), 1u) << num_beams;
    EXPECT_TRUE(objects(outcome)[0]["features"].empty()) << num_beams;
  }
  const Outcome far = run_program({"detect", "--laser", log(flaser(std::vector<std::string>(181, "81.91")))});
  EXPECT_EQ(far.exit_code, 0);
  EXPECT_TRUE(objects(far).at(0)["features"].empty());
}

TEST_F(DetectTest, NeverCrashesOnScansOfNoBeamsOrNoNumbers) {
  for (const std::string& line : {flaser({}), flaser(std::vector<std::string>(181, "nan"))}) {
    const Outcome outcome = run_program({"detect", "--laser", log(line + kScan)});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GE(objects(outcome).size(), 1u);
  }
}

TEST_F(DetectTest, WarnsOfDamagedLinesWithTheirNumber) {
  const Outcome outcome = run_program({"detect", "--laser", log(kScan + "FLASER 181 1.0 2.0\n" + kScan)});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(objects(outcome).size(), 2u);
  EXPECT_NE(outcome.err.find("scanbed: warning: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("a.log:2"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("2 scans, 1 damaged line, 0 other lines"), std::string::npos) << outcome.err;
}

TEST_F(DetectTest, WarnsOfSomeDamagedLinesAndCountsTheRest) {
  std::string text = kScan;
  for (int i = 0; i < 1000; ++i) text += "FLASER 3 1.0\n";
  const Outcome outcome = run_program({"detect", "--laser", log(text)});
  EXPECT_LT(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 30);
  EXPECT_NE(outcome.err.find("1000 damaged lines"), std::string::npos) << outcome.err;
}

TEST_F(DetectTest, RefusesMissingAndEmptyFilesInOneLine) {
  const Outcome missing = run_program({"detect", "--laser", "log:/nowhere/a.log"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(missing.out, "");
  EXPECT_TRUE(missing.err.starts_with("scanbed: error: ")) << missing.err;
  EXPECT_EQ(std::count(missing.err.begin(), missing.err.end(), '\n'), 1);
  EXPECT_EQ(run_program({"detect", "--laser", log("")}).exit_code, 2);
  EXPECT_EQ(run_program({"detect", "--laser", log("nothing here\n")}).exit_code, 2);
}

TEST_F(DetectTest, GivesWhatATruncatedFileHoldsAndThenTheError) {
  std::string text;
  for (int i = 0; i < 200; ++i) {
    std::vector<std::string> ranges;
    for (int j = 0; j < 181; ++j) ranges.push_back(std::to_string(1.0 + 0.001 * ((i * 31 + j * 17) % 997)));
    text += flaser(ranges);
  }
  const std::string packed = tests::gzip(text);
  const Outcome outcome =
      run_program({"detect", "--laser", log(packed.substr(0, packed.size() / 2), "cut.log.gz")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_GT(objects(outcome).size(), 10u);
  EXPECT_LT(objects(outcome).size(), 200u);
  EXPECT_NE(outcome.err.find("scanbed: error: "), std::string::npos) << outcome.err;
}

TEST_F(DetectTest, StopsAtTheLimit) {
  const Outcome outcome = run_program({"detect", "--laser", log(kScan + kScan + kScan), "--limit", "2"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(objects(outcome).size(), 2u);
}

TEST_F(DetectTest, TakesDetectorParameters) {
  // A wall 1 m to the right, which lines explain.
  std::vector<std::string> wall;
  for (int i = 0; i < 181; ++i)
    wall.push_back(i < 60 ? std::to_string(1.0 / std::cos(i * kPi / 180.0)) : "81.91");
  const std::string laser = log(flaser(wall));
  EXPECT_FALSE(objects(run_program({"detect", "--laser", laser})).at(0)["features"].empty());
  const Outcome off = run_program({"detect", "--laser", laser, "--set", "lines=0", "--set", "circles=0"});
  EXPECT_TRUE(objects(off).at(0)["features"].empty());
  const Outcome wrong = run_program({"detect", "--laser", laser, "--set", "line_err=-1"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("line_err"), std::string::npos);
  const Outcome world = run_program({"detect", "--laser", laser, "--set", "sensor.height=1"});
  EXPECT_EQ(world.exit_code, 2);
  EXPECT_NE(world.err.find("a recording has no scenario"), std::string::npos) << world.err;
  const Outcome typo = run_program({"detect", "--laser", laser, "--set", "surfaec.arc_price=1"});
  EXPECT_EQ(typo.exit_code, 2);
  EXPECT_NE(typo.err.find("did you mean 'surface.arc_price'?"), std::string::npos) << typo.err;
}

TEST_F(DetectTest, DetectsInASimulation) {
  const Outcome outcome = run_program({"detect", "--laser", "sim:static_hallway", "--limit", "3"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(objects(outcome).size(), 3u);
  EXPECT_EQ(run_program({"detect", "--laser", "sim"}).exit_code, 2);
}

TEST_F(DetectTest, WarnsOnceOfARecordingOfSeveralLasers) {
  std::string rear = kScan;
  rear.replace(0, 1, "R");
  const std::string laser = log(kScan + rear + kScan + rear);
  const Outcome mixed = run_program({"detect", "--laser", laser});
  EXPECT_EQ(mixed.exit_code, 0);
  EXPECT_EQ(objects(mixed).size(), 4u);
  const std::string warning =
      "mixes scans of several lasers, 'FLASER' and 'RLASER'; read one with " + laser + "?only=FLASER\n";
  EXPECT_NE(mixed.err.find(warning), std::string::npos) << mixed.err;
  EXPECT_EQ(std::count(mixed.err.begin(), mixed.err.end(), '\n'), 2) << mixed.err;
  const Outcome one = run_program({"detect", "--laser", laser + "?only=RLASER"});
  EXPECT_EQ(objects(one).size(), 2u);
  EXPECT_EQ(one.err.find("warning"), std::string::npos) << one.err;
}

TEST_F(DetectTest, RefusesOneFileForTwoOutputs) {
  const std::string file = (folder_ / "x.jsonl").string();
  const Outcome outcome = run_program({"detect", "--laser", log(kScan), "--out", file, "--record", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("--record: "), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(DetectTest, WritesAFile) {
  const std::string out = (folder_ / "o.jsonl").string();
  const Outcome outcome = run_program({"detect", "--laser", log(kScan), "--out", out});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(testing::read_file(out).starts_with("{\"scan\":0"));
}

TEST_F(DetectTest, CallsAFullDiskAFault) {
  const Outcome outcome = run_program({"detect", "--laser", log(kScan)}, "/dev/full");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("standard output: cannot be written: No space left"), std::string::npos);
  EXPECT_EQ(run_program({"detect", "--laser", log(kScan), "--out", "/nowhere/o"}).exit_code, 3);
}

TEST_F(DetectTest, EndsTheRecordingWhereTheOutputFails) {
  const std::string record = (folder_ / "r.jsonl").string();
  const Outcome outcome =
      run_program({"detect", "--laser", log(kScan + kScan), "--record", record}, "/dev/full");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(objects(run_program({"detect", "--laser", "log:" + record})).size(), 1U);
}

TEST_F(DetectTest, KeepsWhatFitsOnTheDisk) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += kScan;
  const std::string out = (folder_ / "o.jsonl").string();
  const std::string shell = std::string("ulimit -f 64; ") + SCANBED_PROGRAM + " detect --laser " + log(text) +
                            " --out " + out + " 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(shell.c_str())), 3);
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_TRUE(testing::read_file(out + ".part").starts_with("{\"scan\":0"));
}

TEST_F(DetectTest, SaysWhatIsWrongWithTheFirstWhereThereIsNoScan) {
  const Outcome outcome = run_program({"detect", "--laser", log("FLASER 3 1 x 3 0 0 0 0 0 0 1 host 0\n")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("(1 damaged"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("the first: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("a.log:1: line skipped: FLASER: a reading is 'x'"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(DetectTest, EndsQuietlyWhenItsReaderLeaves) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += kScan;
  const std::string err = (folder_ / "err").string();
  const std::string code = (folder_ / "code").string();
  const std::string shell = std::string("( ") + SCANBED_PROGRAM + " detect --laser " + log(text) + " 2>" +
                            err + "; echo $? >" + code + " ) | head -n 1 >/dev/null";
  ASSERT_EQ(std::system(shell.c_str()), 0);
  EXPECT_EQ(testing::read_file(code), "0\n");
  EXPECT_EQ(testing::read_file(err).find("error"), std::string::npos) << testing::read_file(err);
  // It stopped long before the end.
  EXPECT_EQ(testing::read_file(err).find("2000 scans"), std::string::npos) << testing::read_file(err);
}

}  // namespace
}  // namespace scanbed::scenarios
