// SPDX-License-Identifier: MIT
// Streams as many scans as an LMS sends in some hours at 37.5 Hz through pseudo-terminal and driver, unpaced,
// and tells whether one was lost, doubled or damaged, how memory grew, and what the driver's share of a core
// was.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/errors/sensor_fault.hpp"
#include "hw/sick/sick_lms.hpp"
#include "tests/support/running_emulator.hpp"

namespace {

using namespace scanbed;

constexpr double kRate_hz = 37.5;

long resident_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmRSS:") continue;
    long kib = 0;
    status >> kib;
    return kib;
  }
  return 0;
}

double cpu_s() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

int run(double hours) {
  const auto num_scans = static_cast<std::int64_t>(hours * 3600.0 * kRate_hz);
  tests::RunningEmulator emulator(tests::quick_sensor_at(500000));
  hw::SickLms laser(tests::patient_driver(emulator.port()));
  LaserScan scan;
  long early_kib = 0;
  std::int64_t num_damaged = 0;
  std::int64_t num_lost = 0;
  std::int64_t num_doubled = 0;
  std::int64_t expected = 0;
  const double start_cpu_s = cpu_s();
  for (std::int64_t i = 0; i < num_scans; ++i) {
    if (!laser.next(scan, RangeSensor::Seconds(30.0))) return 1;
    const auto number = tests::number_of(scan);
    if (!number) {
      ++num_damaged;
    } else if (*number < expected) {
      ++num_doubled;
    } else {
      num_lost += *number - expected;
      expected = *number + 1;
    }
    if (i == num_scans / 20) early_kib = resident_kib();
  }
  std::printf(
      "%lld scans: %lld lost, %lld doubled, %lld damaged; memory %ld KiB early, %ld KiB at the end; %.1f us "
      "of "
      "CPU a scan, sensor, port and check included\n",
      static_cast<long long>(num_scans), static_cast<long long>(num_lost),
      static_cast<long long>(num_doubled), static_cast<long long>(num_damaged), early_kib, resident_kib(),
      1e6 * (cpu_s() - start_cpu_s) / static_cast<double>(num_scans));
  return num_lost + num_doubled + num_damaged == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc > 1 ? std::atof(argv[1]) : 24.0);
  } catch (const SensorFault& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 3;
  }
}
