// SPDX-License-Identifier: MIT
#include "scenarios/load/library.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "scenarios/load/load_scenario.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;
using testing::TemporaryFolder;

class LibraryTest : public ::testing::Test {
 protected:
  void TearDown() override { ::unsetenv("SCANBED_LIBRARY"); }
};

TEST_F(LibraryTest, HoldsThePapersTwoTestsWithoutBeingTold) {
  ::unsetenv("SCANBED_LIBRARY");
  const std::vector<std::string> names = library_names(library_folder());
  EXPECT_NE(std::find(names.begin(), names.end(), "static_hallway"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "dynamic_corridor"), names.end());
}

TEST_F(LibraryTest, HoldsScenariosThatLoadSaySomethingAndAskForSomething) {
  for (const std::string& name : library_names(library_folder())) {
    const Scenario scenario = load_scenario(find_scenario(name));
    EXPECT_EQ(scenario.name, name);
    EXPECT_FALSE(scenario.description.empty()) << name;
    EXPECT_FALSE(scenario.needs.empty()) << name;
  }
}

TEST_F(LibraryTest, FollowsTheEnvironment) {
  const TemporaryFolder folder;
  testing::write_file(folder / "b.yaml", "");
  testing::write_file(folder / "a.yaml", "");
  testing::write_file(folder / "notes.txt", "");
  ::setenv("SCANBED_LIBRARY", folder.path().c_str(), 1);
  EXPECT_EQ(library_names(library_folder()), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(find_scenario("b"), folder / "b.yaml");
}

TEST_F(LibraryTest, RefusesAnEnvironmentThatIsNoFolder) {
  ::setenv("SCANBED_LIBRARY", "/nowhere", 1);
  EXPECT_EQ(error_of([] { library_folder(); }), "SCANBED_LIBRARY: '/nowhere' is no folder");
}

TEST_F(LibraryTest, TakesPathsAsTheyAre) {
  EXPECT_EQ(find_scenario("my.yaml"), "my.yaml");
  EXPECT_EQ(find_scenario("my.yml"), "my.yml");
  EXPECT_EQ(find_scenario("./hall"), "./hall");
}

TEST_F(LibraryTest, FindsTheNamesThatAPatternFits) {
  const TemporaryFolder folder;
  for (const char* name : {"hall_1.yaml", "hall_2.yaml", "room.yaml"}) testing::write_file(folder / name, "");
  ::setenv("SCANBED_LIBRARY", folder.path().c_str(), 1);
  EXPECT_EQ(names_that_fit("hall_*"), (std::vector<std::string>{"hall_1", "hall_2"}));
  EXPECT_EQ(names_that_fit("*"), (std::vector<std::string>{"hall_1", "hall_2", "room"}));
  EXPECT_EQ(names_that_fit("room"), std::vector<std::string>{"room"});
  EXPECT_EQ(names_that_fit("x*/a.yaml"), std::vector<std::string>{"x*/a.yaml"}) << "a path stays one";
  EXPECT_EQ(error_of([] { names_that_fit("x*"); }), "no scenario fits 'x*'; 'scanbed list' shows all");
}

TEST_F(LibraryTest, NamesTheNearestScenario) {
  EXPECT_EQ(error_of([] { find_scenario("static_halway"); }),
            "unknown scenario 'static_halway'; did you mean 'static_hallway'?; 'scanbed list' shows all");
}

}  // namespace
}  // namespace scanbed::scenarios
