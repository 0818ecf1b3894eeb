// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

// A column two metres ahead for two seconds, and a bar that finding it every time passes.
const std::string kEasy =
    "schema: 1\nname: easy\nduration: 2\nworld: [{id: c, cylinder: {at: [2, 0], r: 0.3}, label: column}]\n"
    "score: {circle: {need: {recall: 0.9, truths: 5}}}\n";
const std::string kHard =
    "schema: 1\nname: hard\nduration: 2\nworld: [{id: c, cylinder: {at: [2, 0], r: 0.3}, label: column}]\n"
    "score: {circle: {need: {truths: 1000}}}\n";

class RunTest : public ::testing::Test {
 protected:
  std::string scenario(const std::string& text, const std::string& name = "s.yaml") const {
    return testing::write_file(folder_ / name, text).string();
  }
  testing::TemporaryFolder folder_;
};

TEST_F(RunTest, PrintsTheTableAndPasses) {
  const Outcome outcome = run_program({"run", scenario(kEasy)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("precision"), std::string::npos);
  EXPECT_TRUE(outcome.out.ends_with("easy: 2 of 2 gates passed\n")) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(RunTest, EndsWithOneWhereAGateWasMissed) {
  const Outcome outcome = run_program({"run", scenario(kHard)});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("MISS"), std::string::npos);
}

TEST_F(RunTest, ReportsAKnownFailureWithoutFailing) {
  const Outcome outcome = run_program({"run", scenario(kHard + "known_fail: a test\n")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("0 of 1 gates passed; known failure: a test"), std::string::npos);
}

TEST_F(RunTest, WarnsOfWhatTheScriptDrivesIntoEachOther) {
  const Outcome outcome = run_program(
      {"run", scenario("schema: 1\nname: crash\nduration: 2\nrobot: {speed: 0.5, drive: [{go: 2}]}\n"
                       "world: [{id: post, cylinder: {at: [1, 0], r: 0.3}}]\n")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("warning: crash: at 1.00 s robot runs into post\n"), std::string::npos)
      << outcome.err;
}

// Doing the same twice tells no more; patterns overlap.
TEST_F(RunTest, RunsAScenarioOnceHoweverOftenItIsNamed) {
  const std::string file = scenario(kEasy);
  const Outcome outcome = run_program({"run", file, (folder_ / "./s.yaml").string(), file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, run_program({"run", file}).out);
}

TEST_F(RunTest, TakesASetDurationThatLeavesNoTimeForPictures) {
  const std::string file = scenario(kEasy + "outputs: {pictures: {top: [0, 1.9]}}\n");
  EXPECT_EQ(run_program({"run", file, "--set", "duration=1.5"}).exit_code, 0);
  const Outcome outcome =
      run_program({"run", scenario(kEasy + "outputs: {pictures: {top: [1e3]}}\n", "t.yaml")});
  EXPECT_EQ(outcome.exit_code, 2) << "the file itself has no time for it";
}

TEST_F(RunTest, WarnsOfARecordingOfAnotherScenario) {
  const std::string log = (folder_ / "r.jsonl").string();
  ASSERT_EQ(run_program({"run", scenario(kEasy), "--record", log}).exit_code, 0);
  const Outcome same = run_program({"run", scenario(kEasy), "--laser", "log:" + log});
  EXPECT_EQ(same.err.find("warning"), std::string::npos) << same.err;
  EXPECT_EQ(same.out.find("seed"), std::string::npos) << same.out;
  const Outcome other = run_program({"run", scenario(kHard, "t.yaml"), "--laser", "log:" + log});
  EXPECT_NE(other.err.find("r.jsonl: was recorded in the scenario '"), std::string::npos) << other.err;
}

TEST_F(RunTest, EndsWithTheWorstOfSeveralScenarios) {
  const Outcome outcome = run_program({"run", scenario(kEasy), scenario(kHard, "t.yaml")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("hard: circle truths >= 1000: missed in 1 of 1"), std::string::npos)
      << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("2 scenarios, 2 runs: 1 missed a gate\n")) << outcome.out;
  EXPECT_EQ(outcome.out.find("gates passed"), std::string::npos)
      << "a table of each run only where asked for";
  const Outcome tables = run_program({"run", scenario(kEasy), scenario(kHard, "t.yaml"), "--tables"});
  EXPECT_NE(tables.out.find("easy: 2 of 2"), std::string::npos);
  EXPECT_NE(tables.out.find("hard: 0 of 1"), std::string::npos);
}

TEST_F(RunTest, GivesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const auto json = [](const std::string& seed) {
    return run_program({"run", "static_hallway", "--seed", seed, "--json", "-"}).out;
  };
  const std::string first = json("1");
  EXPECT_EQ(first, json("1"));
  const nlohmann::json one = nlohmann::json::parse(first)["runs"][0];
  const nlohmann::json two = nlohmann::json::parse(json("2"))["runs"][0];
  EXPECT_EQ(one["seed"], 1);
  EXPECT_NE(one["scores"], two["scores"]);
}

TEST_F(RunTest, GivesTheSameBytesForAnyNumberOfWorkers) {
  for (const char* backend : {"planar", "spatial"}) {
    const auto json = [&](const std::string& jobs) {
      const Outcome outcome = run_program({"run", "noise_*", "random_rooms", "--seed", "11..13", "--jobs",
                                           jobs, "--backend", backend, "--json", "-"});
      EXPECT_EQ(outcome.err, "");
      return outcome.out;
    };
    const std::string alone = json("1");
    EXPECT_EQ(nlohmann::json::parse(alone)["runs"].size(), 12u);
    EXPECT_EQ(json("4"), alone) << backend;
  }
}

// The robot stands where one room in three has furniture; run alone, the seed that is named fails as well.
TEST_F(RunTest, NamesTheSeedWhoseWorldCannotBe) {
  const std::string file = scenario(
      "schema: 1\nname: rooms\nduration: 0.2\ngenerate: rooms\nrobot: {pose: [1.9, 0.5, 0], radius: 0.5}\n");
  const Outcome many = run_program({"run", file, "--seed", "1..40"});
  EXPECT_EQ(many.exit_code, 2);
  const std::size_t at = many.err.find(" (seed ");
  ASSERT_NE(at, std::string::npos) << many.err;
  const int seed = std::stoi(many.err.substr(at + 7));
  const Outcome alone = run_program({"run", file, "--seed", std::to_string(seed)});
  EXPECT_EQ(alone.err, many.err.substr(0, at) + "\n");
}

TEST_F(RunTest, RunsEachScenarioWithEachSeed) {
  const Outcome outcome = run_program({"run", scenario(kEasy), "--seed", "5..7", "--json", "-"});
  const nlohmann::json runs = nlohmann::json::parse(outcome.out)["runs"];
  ASSERT_EQ(runs.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(runs[i]["seed"], 5 + i);
}

TEST_F(RunTest, PutsPicturesOfSeveralSeedsApart) {
  const std::string file = scenario(kEasy + "outputs: {pictures: {top: [1]}}\n");
  EXPECT_EQ(run_program({"run", file, "--seed", "1..2", "--out", (folder_ / "p").string()}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "p/seed_1/easy_top_1s.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "p/seed_2/easy_top_1s.png"));
}

TEST_F(RunTest, PutsJsonAloneOnStandardOutputOrIntoAFile) {
  const Outcome stdout_json = run_program({"run", scenario(kEasy), "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(stdout_json.out)["runs"][0]["scenario"], "easy");
  const std::string file = (folder_ / "r.json").string();
  const Outcome with_table = run_program({"run", scenario(kEasy), "--json", file});
  EXPECT_NE(with_table.out.find("gates passed"), std::string::npos);
  EXPECT_EQ(testing::read_file(file), stdout_json.out);
  EXPECT_EQ(run_program({"run", scenario(kEasy), "--quiet"}).out, "");
}

TEST_F(RunTest, LetsTheCommandLineChangeWorldAndDetector) {
  const Outcome gone = run_program({"run", scenario(kEasy), "--set", "world.c.cylinder.at=[50, 0]"});
  EXPECT_EQ(gone.exit_code, 1);
  const Outcome blind = run_program({"run", scenario(kEasy), "--set", "circles=0"});
  EXPECT_EQ(blind.exit_code, 1);
  EXPECT_NE(blind.out.find("truths"), std::string::npos);
}

TEST_F(RunTest, CountsOnARecordingWithoutScoring) {
  const std::string log =
      testing::write_file(folder_ / "a.log", testing::flaser(std::vector<std::string>(181, "2.0"))).string();
  const Outcome outcome = run_program({"run", scenario(kEasy), "--laser", "log:" + log});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("1 scans"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("not scored"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("warning: easy: not scored"), std::string::npos) << outcome.err;
}

TEST_F(RunTest, WarnsOfARecordingOfSeveralLasers) {
  const std::string scan = testing::flaser(std::vector<std::string>(181, "2.0"));
  const std::string file = testing::write_file(folder_ / "a.log", scan + "R" + scan.substr(1)).string();
  const Outcome mixed = run_program({"run", scenario(kEasy), "--laser", "log:" + file});
  EXPECT_EQ(mixed.exit_code, 0) << mixed.err;
  EXPECT_NE(mixed.err.find("mixes scans of several lasers, 'FLASER' and 'RLASER'"), std::string::npos);
}

TEST_F(RunTest, RefusesBadInputInOneLine) {
  const auto refused = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("scanbed: error: ")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(refused({"run", "static_halway"}).find("did you mean 'static_hallway'?"), std::string::npos);
  EXPECT_NE(refused({"run", scenario("a: [\n")}).find("not valid YAML"), std::string::npos);
  EXPECT_NE(refused({"run", scenario("")}).find("is empty"), std::string::npos);
  refused({"run", "/nowhere/a.yaml"});
  refused({"run"});
  refused({"run", "nothing_*"});
  refused({"run", scenario(kEasy), "--seed", "1..2", "--record", (folder_ / "r.jsonl").string()});
  refused({"run", scenario(kEasy), "--seed", "1..2", "--laser", "log:/nowhere"});
  EXPECT_NE(refused({"run", scenario(kEasy), scenario(kHard, "t.yaml"), "--laser", "log:/nowhere"})
                .find("--laser log:/nowhere: its scans show one run; found 2"),
            std::string::npos);
  refused({"run", scenario(kEasy), "--tables", "--quiet"});
  refused({"run", scenario(kEasy), "--seed", "4", "--set", "seed=9"});
  refused({"run", scenario(kEasy), "--tables", "--json", "-"});
  refused({"run", scenario(kEasy), "--jobs", "0"});
  refused({"run", scenario(kEasy), "--laser", "sick:/dev/ttyS0?baud=1"});
  refused({"run", scenario(kEasy), "--laser", "sim:static_hallway"});
  refused({"run", scenario(kEasy), "--preset", "rubust"});
  refused({"run", scenario(kEasy), "--config", "/nowhere.yaml"});
  refused({"run", scenario(kEasy), "--json", "x.jsonl", "--record", "x.jsonl"});
  // Nothing is written over what is read.
  const std::string easy = scenario(kEasy);
  EXPECT_NE(refused({"run", easy, "--json", easy}).find("is what SCENARIO reads"), std::string::npos);
  const std::string log = testing::write_file(folder_ / "x.log", "FLASER\n");
  EXPECT_NE(refused({"run", easy, "--laser", "log:" + log, "--json", log}).find("is what --laser reads"),
            std::string::npos);
  refused({"detect", "--laser", "log:" + log, "--out", log});
  refused({"detect", "--laser", "log:" + log, "--record", log});
  refused({"convert", log, log});
  refused({"export", easy, "--mjcf", easy});
  refused({"run", easy, "--laser", "log:" + log, "--out", (folder_ / "pictures").string()});
  refused({"run", easy, "--laser", "log:" + log, "--backend", "spatial"});
  refused({"run", easy, "--laser", "log:" + log, "--seed", "3"});
  refused({"run", easy, "--laser", "log:" + log, "--set", "sensor.noise.sigma=0.03"});
  refused({"detect", "--laser", "log:" + log, "--backend", "spatial"});
  EXPECT_NE(refused({"run", easy, "--set", "surfac.min_gap_m=0.1"}).find("did you mean 'surface.min_gap_m'?"),
            std::string::npos);
  const std::string text = testing::write_file(folder_ / "notes.txt", std::string(100, '\n') + "hello\n\0\n");
  EXPECT_NE(refused({"detect", "--laser", "log:" + text}).find("is no recording that is known"),
            std::string::npos);
  refused({"run", easy, "--out", "-"});
  EXPECT_NE(
      refused({"run", easy, "--out", (folder_ / "pictures").string()}).find("no scenario asks for pictures"),
      std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "pictures"));
  // A name with control characters stays one line too.
  refused({"run", "a\nb"});
  // Pictures of the one would overwrite those of the other, and the summary would take both for one.
  EXPECT_NE(refused({"run", scenario(kEasy), scenario(kEasy + "seed: 2\n", "t.yaml")})
                .find("t.yaml: name: 'easy' is that of "),
            std::string::npos);
}

TEST_F(RunTest, RecordsTheOneScenarioThatAPatternFits) {
  const std::string file = (folder_ / "r.jsonl").string();
  const Outcome outcome = run_program({"run", "empty_corrid*", "--record", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(testing::read_file(file).find("name: empty_corridor"), std::string::npos);
}

TEST_F(RunTest, HoldsAgainstTheGatesOfThePipelineThatRuns) {
  const std::string file = scenario(
      "schema: 1\nname: gates\nduration: 1\nworld: [{id: c, cylinder: {at: [2, 0], r: 0.3}, label: column}]\n"
      "score: {circle: {need: [{preset: robust, truths: 1}, {preset: paper, truths: 1000}]}}\n");
  EXPECT_EQ(run_program({"run", file}).exit_code, 0);
  const Outcome paper = run_program({"run", file, "--set", "pipeline=paper"});
  EXPECT_EQ(paper.exit_code, 1) << paper.out << paper.err;
  EXPECT_NE(paper.out.find("preset paper"), std::string::npos) << paper.out;
}

TEST_F(RunTest, CallsWhatCannotBeWrittenAFault) {
  EXPECT_EQ(run_program({"run", scenario(kEasy)}, "/dev/full").exit_code, 3);
  EXPECT_EQ(run_program({"run", scenario(kEasy), "--json", "/nowhere/r.json"}).exit_code, 3);
  EXPECT_EQ(run_program({"run", scenario(kEasy), "--json", "/dev/full"}).exit_code, 3);
  const std::string pictures = "outputs: {pictures: {top: [0]}}\n";
  EXPECT_EQ(run_program({"run", scenario(kEasy + pictures), "--out", "/dev/null/x"}).exit_code, 3);
}

TEST_F(RunTest, WritesItsFileAlsoWhereNobodyReadsWhatIsPrinted) {
  const std::string file = (folder_ / "r.json").string();
  for (const std::string& seeds : {std::string("1"), std::string("1..2")}) {
    const std::vector<std::string> run = {"run", scenario(kEasy), "--seed", seeds, "--json", file};
    EXPECT_EQ(run_program(run, "/dev/full").exit_code, 3);
    const std::string written = testing::read_file(file);
    EXPECT_EQ(run_program(run).exit_code, 0);
    EXPECT_EQ(written, testing::read_file(file));
    std::filesystem::remove(file);
  }
}

TEST_F(RunTest, KeepsWhatWasDoneBeforeARunThatFails) {
  const std::string pictures = "outputs: {pictures: {top: [1]}}\n";
  const std::string easy = scenario(kEasy + pictures);
  const std::string hard = scenario(kHard + pictures, "h.yaml");
  const std::string json = (folder_ / "r.json").string();
  const std::string out = (folder_ / "p").string();
  std::filesystem::create_directories(folder_ / "p/hard_top_1s.png");
  const Outcome outcome = run_program({"run", easy, hard, "--out", out, "--json", json});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("hard_top_1s.png"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("stopped after 1 of 2 runs"), std::string::npos) << outcome.out;
  const auto runs = nlohmann::json::parse(testing::read_file(json)).at("runs");
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].at("scenario"), "easy");
}

TEST_F(RunTest, KnowsBeforeItRunsWhatCannotBeWritten) {
  const Outcome outcome = run_program({"run", scenario(kEasy), "--json", "/nowhere/r.json"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "scanbed: error: /nowhere/r.json: cannot be written: No such file or directory\n");
}

TEST_F(RunTest, CallsAPictureThatCannotBeWrittenAFault) {
  const std::string file = scenario(kEasy + "outputs: {pictures: {top: [1]}}\n");
  std::filesystem::create_directories(folder_ / "p/easy_top_1s.png");
  const Outcome outcome = run_program({"run", file, "--out", (folder_ / "p").string()});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("easy_top_1s.png: is a folder, not a file"), std::string::npos) << outcome.err;
}

TEST_F(RunTest, TakesPicturesOnlyWhereAFolderIsGiven) {
  const std::string file = scenario(kEasy + "outputs: {pictures: {top: [1]}}\n");
  EXPECT_EQ(run_program({"run", file}).out.find("picture:"), std::string::npos);
  const Outcome outcome = run_program({"run", file, "--out", (folder_ / "p").string()});
  EXPECT_EQ(outcome.exit_code, 0);
  const std::filesystem::path picture = folder_ / "p/easy_top_1s.png";
  EXPECT_TRUE(outcome.out.ends_with("picture: " + picture.string() + "\n")) << outcome.out;
  EXPECT_EQ(testing::read_file(picture).substr(1, 3), "PNG");
}

}  // namespace
}  // namespace scanbed::scenarios
