// SPDX-License-Identifier: MIT
// What we write is read by programs that nobody here wrote: @mcap/core and @foxglove/rosbag, under node.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

int run(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str());
}

/// The folder of the readers with what they need installed, once for all tests; or why there is none.
class Readers {
 public:
  static const Readers& instance() {
    static const Readers kReaders;
    return kReaders;
  }

  const std::string& reason_for_none() const { return reason_; }

  /// Whether the reader finds no fault with the file.
  bool accepts(const std::string& script, const std::filesystem::path& file) const {
    return run("cd '" + (folder_ / "verify").string() + "' && node " + script + " '" + file.string() + "'") ==
           0;
  }

 private:
  Readers() {
    const std::filesystem::path source = SCANBED_SOURCE_DIR "/../shared/verify";
    if (!std::filesystem::exists(source)) {
      reason_ = "no readers at " + source.string();
    } else if (run("node --version") != 0 || run("npm --version") != 0) {
      reason_ = "node or npm is not installed";
    } else {
      std::filesystem::copy(source, folder_ / "verify", std::filesystem::copy_options::recursive);
      const std::string target = (folder_ / "verify").string();
      if (run("chmod -R u+w '" + target + "' && cd '" + target + "' && npm install --no-audit --no-fund") !=
          0) {
        reason_ = "npm cannot install the readers' packages (no network?)";
      }
    }
  }

  TemporaryFolder folder_;
  std::string reason_;
};

/// A recording with everything in it: two sources, odometry, features, truth, several chunks.
void write_rich(const std::filesystem::path& path, const RecordingMetadata& metadata) {
  const auto writer = create_recording(path, metadata);
  const Features features = made_features();
  for (LaserScan scan : made_scans(20)) {
    const Truth truth = made_truth(scan.num_beams());
    if (scan.index % 3 == 1) scan.source = "RLASER";
    if (scan.index % 5 == 4) scan.health = {.severity = 2, .is_polluted = true};
    writer->write({.scan = scan, .features = &features, .truth = scan.index % 2 == 0 ? &truth : nullptr});
  }
  writer->finish();
}

TEST(IndependentReadersTest, AcceptOurMcapFiles) {
  const Readers& readers = Readers::instance();
  if (!readers.reason_for_none().empty()) GTEST_SKIP() << readers.reason_for_none();
  const TemporaryFolder folder;
  write_rich(folder / "x.mcap", {{"seed", "7"}});
  EXPECT_TRUE(readers.accepts("verify_mcap.mjs", folder / "x.mcap"));
  // The reader is one that finds faults.
  std::string bytes = bytes_of(folder / "x.mcap");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(folder / "y.mcap", std::ios::binary) << bytes;
  EXPECT_FALSE(readers.accepts("verify_mcap.mjs", folder / "y.mcap"));
}

TEST(IndependentReadersTest, AcceptOurBags) {
  const Readers& readers = Readers::instance();
  if (!readers.reason_for_none().empty()) GTEST_SKIP() << readers.reason_for_none();
  const TemporaryFolder folder;
  write_rich(folder / "x.bag", {});
  EXPECT_TRUE(readers.accepts("verify_rosbag.mjs", folder / "x.bag"));
  std::filesystem::resize_file(folder / "x.bag", std::filesystem::file_size(folder / "x.bag") - 10);
  EXPECT_FALSE(readers.accepts("verify_rosbag.mjs", folder / "x.bag"));
}

/// What a program prints on standard output and error.
std::string output_of(const std::string& command, const std::filesystem::path& file) {
  run("sh -c '" + command + "' 2>&1 | cat > " + file.string() + " #");
  return bytes_of(file);
}

// The tools of ROS itself (group ros of .ci/debian-packages).
TEST(IndependentReadersTest, RosbagFindsOurBagsInOrder) {
  if (run("command -v rosbag") != 0) GTEST_SKIP() << "rosbag (python3-rosbag) is missing";
  const TemporaryFolder folder;
  std::vector<LaserScan> scans = made_scans(20);
  for (LaserScan& scan : scans) scan.X_OR.reset();  // what is odometry needs python3-tf2-msgs
  const std::string bag = (folder / "x.bag").string();
  std::ofstream(bag, std::ios::binary) << recorded("x.bag", scans);
  const std::string info = output_of("rosbag info " + bag, folder / "info");
  EXPECT_NE(info.find("sensor_msgs/LaserScan"), std::string::npos) << info;
  EXPECT_NE(info.find("90c7ef2dc6895d81024acba2ac42f369"), std::string::npos) << info;
  EXPECT_EQ(info.find("unindexed"), std::string::npos) << info;
  const std::string check = output_of("rosbag check " + bag, folder / "check");
  // Comments in definitions count there, and ours have none: a migration that changes nothing may be offered.
  const bool is_fine = check.find("does not need any migrations") != std::string::npos ||
                       check.find("All rules defined") != std::string::npos;
  EXPECT_TRUE(is_fine) << check;
}

}  // namespace
}  // namespace scanbed::hw
