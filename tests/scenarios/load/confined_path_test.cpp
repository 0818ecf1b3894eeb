// SPDX-License-Identifier: MIT
#include "scenarios/load/confined_path.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;
using testing::write_file;

class ConfinedPathTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(outside_ / "inner/deep");
    write_file(outside_ / "secret.yaml", "a: 1\n");
    write_file(outside_ / "inner/near.yaml", "a: 1\n");
    write_file(outside_ / "inner/deep/far.yaml", "a: 1\n");
    inner_ = outside_ / "inner";
  }

  std::string error(const std::string& name) const {
    return testing::error_of([&] { find_confined(Place{nullptr, 3, 7}, name, inner_); });
  }

  TemporaryFolder outside_;
  fs::path inner_;
};

TEST_F(ConfinedPathTest, FindsNeighboursAndWhatLiesBelow) {
  EXPECT_EQ(find_confined({}, "near.yaml", inner_), fs::canonical(inner_ / "near.yaml"));
  EXPECT_EQ(find_confined({}, "deep/far.yaml", inner_), fs::canonical(inner_ / "deep/far.yaml"));
  EXPECT_EQ(find_confined({}, "./near.yaml", inner_), fs::canonical(inner_ / "near.yaml"));
}

TEST_F(ConfinedPathTest, FindsFilesOfTheLibraryFromAnywhere) {
  EXPECT_EQ(find_confined({}, "static_hallway.yaml", inner_).filename(), "static_hallway.yaml");
  EXPECT_EQ(find_confined({}, "static_hallway.yaml", {}).filename(), "static_hallway.yaml");
}

TEST_F(ConfinedPathTest, RefusesToLeaveTheFolder) {
  const std::string rule = ": expected a file beside this one or of the library, without '..'";
  EXPECT_NE(error("../secret.yaml").find("'../secret.yaml'" + rule), std::string::npos);
  EXPECT_NE(error("deep/../../secret.yaml").find(rule), std::string::npos);
  EXPECT_NE(error("/etc/passwd").find(rule), std::string::npos);
  EXPECT_NE(error(std::string("near.yaml\0x", 11)).find(rule), std::string::npos);
}

TEST_F(ConfinedPathTest, FollowsLinksOnlyWithin) {
  fs::create_symlink("near.yaml", inner_ / "alias.yaml");
  fs::create_symlink("../secret.yaml", inner_ / "leak.yaml");
  fs::create_directory_symlink("..", inner_ / "up");
  EXPECT_EQ(find_confined({}, "alias.yaml", inner_), fs::canonical(inner_ / "near.yaml"));
  EXPECT_NE(error("leak.yaml").find("'leak.yaml' leads out of the folder of its file"), std::string::npos);
  EXPECT_NE(error("up/secret.yaml").find("leads out of the folder"), std::string::npos);
}

TEST_F(ConfinedPathTest, RefusesFoldersDevicesAndNothing) {
  EXPECT_NE(error("deep").find("'deep' is no file"), std::string::npos);
  EXPECT_NE(error("none.yaml").find("no file 'none.yaml' beside this one or in the library"),
            std::string::npos);
  EXPECT_NE(error(std::string(10'000, 'x')).find("no file"), std::string::npos);
  EXPECT_NE(error("").find("is no file"), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
