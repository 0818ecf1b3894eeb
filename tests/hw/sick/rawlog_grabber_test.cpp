// SPDX-License-Identifier: MIT
// An LMS client that others wrote: rawlog-grabber of MRPT (Debian's mrpt-apps) reads the emulated sensor.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/support/running_emulator.hpp"

namespace scanbed::hw {
namespace {

namespace fs = std::filesystem;

const char* const kSettings = R"([global]
rawlog_prefix = FOLDER/out
time_between_launches = 10
SF_max_time_span = 0.25
use_sensoryframes = 0
GRABBER_PERIOD_MS = 200
rawlog_GZ_compress_level = 0
[LASER]
driver = CSickLaserSerial
process_rate = 50
max_queue_len = 200
sensorLabel = SICK
preview = false
COM_port_LIN = FOLDER/lms
COM_baudRate = 38400
mm_mode = 1
FOV = 180
resolution = 50
)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string log_in(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".rawlog") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  return "";
}

/// Whether the file holds this scan: its 361 ranges are there as an array of floats.
bool holds_scan(const std::string& bytes, std::int64_t number) {
  std::array<float, 361> ranges{};
  for (int beam = 0; beam < 361; ++beam) {
    ranges.at(static_cast<std::size_t>(beam)) =
        static_cast<float>(tests::numbered_steps(number, beam)) * 0.001F;
  }
  // Products of floats may differ in the last bit, so the beams are looked for by value.
  const std::size_t size = sizeof ranges;
  for (std::size_t at = 0; at + size <= bytes.size(); ++at) {
    std::array<float, 361> there{};
    std::memcpy(there.data(), bytes.data() + at, 3 * sizeof(float));
    if (std::abs(there[2] - ranges[2]) > 1e-5F || std::abs(there[1] - ranges[1]) > 1e-5F) continue;
    std::memcpy(there.data(), bytes.data() + at, size);
    bool is_same = true;
    for (std::size_t i = 0; i < there.size() && is_same; ++i)
      is_same = std::abs(there.at(i) - ranges.at(i)) < 1e-5F;
    if (is_same) return true;
  }
  return false;
}

TEST(RawlogGrabberTest, ReadsTheEmulatedSensor) {
  if (std::system("command -v rawlog-grabber > /dev/null") != 0)
    GTEST_SKIP() << "rawlog-grabber (group mrpt of .ci/debian-packages) is missing";
  const fs::path folder = fs::path(::testing::TempDir()) / ("grabber_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  {
    tests::RunningEmulator emulator({}, tests::numbered_source(), {}, folder / "lms");
    std::ofstream(folder / "sick.ini") << replaced(kSettings, "FOLDER", folder.string());
    // It ends where its standard input does, so that is kept open; and it has no other way to end.
    const std::string command = "sleep 15 | timeout 14 rawlog-grabber " + (folder / "sick.ini").string() +
                                " > " + (folder / "grabber.out").string() + " 2>&1";
    [[maybe_unused]] const int ignored = std::system(command.c_str());
  }
  const std::string bytes = log_in(folder);
  int num_scans = 0;
  for (std::int64_t number = 0; number < 100; ++number) num_scans += holds_scan(bytes, number) ? 1 : 0;
  // Some 4 a second, once it has gone through its start.
  EXPECT_GE(num_scans, 10);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace scanbed::hw
