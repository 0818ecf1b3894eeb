// SPDX-License-Identifier: MIT
#include "hw/scip/scip_laser.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/errors/input_error.hpp"
#include "hw/scip/emulated_scip.hpp"
#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "tests/support/interposed_device.hpp"
#include "tests/support/running_device.hpp"
#include "tests/support/wide_sensor.hpp"

namespace scanbed::hw {
namespace {

using tests::RunningDevice;
using tests::WideSensor;

constexpr RangeSensor::Seconds kPatience{20.0};

ScipOptions network(int port) {
  ScipOptions options;
  options.host = "127.0.0.1";
  options.port = port;
  options.recovery.pause_s = 0.05;
  return options;
}

/// Every beam must be one of the same source scan.
void expect_true_scan(const LaserScan& scan) {
  const int first = WideSensor::beam_at(scan.geometry.bearing_rad(0));
  const int shift = (static_cast<int>(std::lround(scan.range_m[0] * 1000.0)) - 1000 - first + 8000) % 4000;
  for (int i = 0; i < scan.num_beams(); ++i) {
    const int beam = WideSensor::beam_at(scan.geometry.bearing_rad(i));
    ASSERT_DOUBLE_EQ(scan.range_m[static_cast<std::size_t>(i)], WideSensor::range_m(shift, beam)) << i;
  }
}

void expect_true_scans(RangeSensor& laser, int count, int num_beams) {
  LaserScan scan;
  double last_s = -1e300;
  for (int i = 0; i < count; ++i) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    ASSERT_EQ(scan.num_beams(), num_beams);
    ASSERT_GE(scan.time_s, last_s);
    last_s = scan.time_s;
    expect_true_scan(scan);
  }
}

TEST(ScipLaserTest, StreamsOverTheNetwork) {
  WideSensor source;
  EmulatedScip sensor({.is_paced = false}, source);
  RunningDevice running(sensor);
  const auto laser = open_scip(network(running.port()));
  expect_true_scans(*laser, 20, 1081);
}

TEST(ScipLaserTest, GetsASensorOutOfScip1AndOutOfItsClocksMode) {
  for (const bool in_clock_mode : {false, true}) {
    WideSensor source;
    EmulatedScip sensor(
        {.is_paced = false, .starts_in_scip_1 = !in_clock_mode, .starts_in_clock_mode = in_clock_mode},
        source);
    RunningDevice running(sensor);
    const auto laser = open_scip(network(running.port()));
    expect_true_scans(*laser, 2, 1081);
  }
}

TEST(ScipLaserTest, DropsDamagedScans) {
  WideSensor source;
  EmulatedScip sensor({.is_paced = false, .damage_every = 3}, source);
  RunningDevice running(sensor);
  const auto laser = open_scip(network(running.port()));
  expect_true_scans(*laser, 20, 1081);
}

TEST(ScipLaserTest, BeginsAnewWhereTheSensorStops) {
  WideSensor source;
  EmulatedScip sensor({.stop_after = 3}, source);
  RunningDevice running(sensor);
  const auto laser = open_scip(network(running.port()));
  expect_true_scans(*laser, 6, 1081);
}

TEST(ScipLaserTest, FindsASensorThatStillStreamsAtASerialPort) {
  WideSensor source;
  EmulatedScip sensor({}, source);
  PseudoTerminal terminal({});
  StopSignal stop;
  std::thread thread([&] { serve(sensor, terminal, stop); });
  ScipOptions options;
  options.path = terminal.path();
  {
    // A host that died in the middle of a stream.
    SerialPort port(terminal.path());
    const std::string command = "MD0000108001000\n";
    port.write({reinterpret_cast<const std::uint8_t*>(command.data()), command.size()}, stop);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }
  {
    const auto laser = open_scip(options);
    LaserScan scan;
    ASSERT_TRUE(laser->next(scan, kPatience));
    expect_true_scan(scan);
  }
  stop.give();
  thread.join();
}

/// An emulated sensor that puts something before the echo of each scan.
class GarblingScip final : public ByteDevice {
 public:
  GarblingScip(ByteDevice& sensor, std::string garbage) : sensor_(sensor), garbage_(std::move(garbage)) {}

  void receive(ByteView bytes, double now_s) override {
    if (!bytes.empty()) last_request.assign(bytes.begin(), bytes.end());
    sensor_.receive(bytes, now_s);
  }
  void run(double now_s, Bytes& out) override {
    Bytes bytes;
    sensor_.run(now_s, bytes);
    std::string text(bytes.begin(), bytes.end());
    for (std::size_t at = text.find("MD"); at != std::string::npos;
         at = text.find("MD", at + garbage_.size() + 2)) {
      // The echo of the command itself is left alone.
      if (text.compare(at + 15, 4, "\n99b") == 0) text.insert(at, garbage_);
    }
    out.insert(out.end(), text.begin(), text.end());
  }
  double next_event_s() const override { return sensor_.next_event_s(); }
  void hang_up() override { sensor_.hang_up(); }

  std::string last_request;

 private:
  ByteDevice& sensor_;
  std::string garbage_;
};

TEST(ScipLaserTest, GivesUpWhereNoEchoIsRightAndStopsTheSensor) {
  WideSensor source;
  EmulatedScip emulated({.is_paced = false}, source);
  GarblingScip sensor(emulated, "zz");
  {
    RunningDevice running(sensor);
    ScipOptions options = network(running.port());
    options.recovery.num_first_attempts = 1;
    options.reply_s = 10.0;
    const auto laser = open_scip(options);
    LaserScan scan;
    try {
      laser->next(scan, kPatience);
      ADD_FAILURE() << "a scan";
    } catch (const SensorFault& fault) {
      EXPECT_NE(std::string(fault.what()).find("nothing but damaged scans"), std::string::npos)
          << fault.what();
    }
  }
  EXPECT_EQ(sensor.last_request, "QT\n");
}

TEST(ScipLaserTest, KeepsTheScanBehindALineOfGarbage) {
  WideSensor source;
  EmulatedScip emulated({.is_paced = false}, source);
  GarblingScip sensor(emulated, "zz\n");
  RunningDevice running(sensor);
  const auto laser = open_scip(network(running.port()));
  expect_true_scans(*laser, 5, 1081);
}

TEST(ScipLaserTest, SaysThatNothingIsThere) {
  int port = 0;
  {
    TcpListener closed(0);
    port = closed.port();
  }
  const auto laser = open_scip(network(port));
  LaserScan scan;
  EXPECT_THROW(laser->next(scan, kPatience), SensorFault);
}

TEST(ScipLaserTest, RefusesBadOptions) {
  EXPECT_THROW(open_scip({}), InputError);
  EXPECT_THROW(open_scip(network(0)), InputError);
  ScipOptions options = network(10940);
  options.baud = 0;
  EXPECT_THROW(open_scip(options), InputError);
}

ScipParameters two_steps() {
  ScipParameters p = utm_30lx();
  p.last_step = 1;
  return p;
}

TEST(ScipScansTest, ReadsTheRangesOfAMessage) {
  ScipScans scans(two_steps());
  EXPECT_EQ(scans.command(), "MD0000000101000");
  LaserScan scan;
  ASSERT_EQ(scans.take({"MD0000000101000", "99b", "00?Xg", "0?X001" + std::string(1, scip_sum("0?X001"))},
                       9.0, scan),
            ScipScans::Outcome::kScan);
  EXPECT_EQ(scan.range_m[0], 1.0);
  EXPECT_EQ(scan.range_m[1], kNoEcho);  // 1 mm is the sensor's code for nothing in range
  // The sweep ends at step 1 of 1440 of a turn of 25 ms.
  EXPECT_NEAR(scan.time_s, 9.0 - 0.025 / 1440, 1e-9);
}

TEST(ScipScansTest, TimesAreThoseOfTheFirstBeam) {
  ScipParameters p = utm_30lx();
  p.first_step = 360;
  p.last_step = 361;
  ScipScans scans(p);
  LaserScan scan;
  ASSERT_EQ(scans.take({"MD0360036101000", "99b", "00?Xg", "0?X001" + std::string(1, scip_sum("0?X001"))},
                       9.0, scan),
            ScipScans::Outcome::kScan);
  // One step lies between the two beams; the stamp is of step 0, a quarter of a turn before.
  EXPECT_NEAR(scan.time_s, 9.0 - 0.025 / 1440, 1e-9);
}

/// A link that gives one message and says what a byte takes.
class OneMessage final : public ByteLink {
 public:
  explicit OneMessage(double byte_s) : byte_s_(byte_s) {}
  std::size_t read(std::span<std::uint8_t> buffer, double /*timeout_s*/,
                   const StopSignal& /*stop*/) override {
    const std::string_view text = "QT\n00P\n\n";
    std::copy(text.begin(), text.end(), buffer.begin());
    return text.size();
  }
  void write(ByteView /*bytes*/, const StopSignal& /*stop*/) override {}
  void flush_input() override {}
  double byte_s() const override { return byte_s_; }

 private:
  double byte_s_;
};

TEST(ScipClientTest, AMessageWasOnTheWireForItsBytes) {
  OneMessage link(0.01);
  StopSignal stop;
  ScipClient client(link, 1.0, stop);
  const double before_s = steady_now_s();
  client.ask("QT");
  const double after_s = steady_now_s();
  EXPECT_GE(client.sent_s(), before_s - 8 * 0.01 - 1e-9);
  EXPECT_LE(client.sent_s(), after_s - 8 * 0.01 + 1e-9);
  // The second came right behind the first: for longer than that it was not on any wire.
  client.ask("QT");
  EXPECT_GE(client.sent_s(), before_s);
}

/// A sensor at a baud of its own, at a port whose host it hears at that alone.
class SerialScip final : public tests::InterposedDevice {
 public:
  enum class Change {
    kDone,
    kRefused,
    kNone
  };  ///< what SS brings about; kNone: it says "done" and does nothing

  SerialScip(ByteDevice& sensor, const PseudoTerminal& terminal, Change change)
      : InterposedDevice(sensor), terminal_(terminal), change_(change) {}

  void receive(ByteView bytes, double now_s) override {
    if (terminal_.host_baud() != baud) return;
    const std::string text(bytes.begin(), bytes.end());
    if (!text.starts_with("SS")) return hand_on(bytes, now_s);
    const std::string status = change_ == Change::kRefused ? "04" : "00";
    answer(text + status + scip_sum(status) + "\n\n");
    if (change_ == Change::kDone) baud = std::stoi(text.substr(2));
  }

  std::atomic<int> baud = 19200;

 private:
  const PseudoTerminal& terminal_;
  Change change_;
};

TEST(ScipLaserTest, TakesASerialSensorToTheBaudThatIsAskedForWhereItCan) {
  using Change = SerialScip::Change;
  for (const Change change : {Change::kDone, Change::kRefused, Change::kNone}) {
    WideSensor source;
    EmulatedScip emulated({}, source);
    PseudoTerminal terminal({});
    SerialScip sensor(emulated, terminal, change);
    StopSignal stop;
    std::thread thread([&] { serve(sensor, terminal, stop); });
    ScipOptions options;
    options.path = terminal.path();
    options.reply_s = 0.1;
    options.recovery.num_first_attempts = 100;
    {
      const auto laser = open_scip(options);
      LaserScan scan;
      ASSERT_TRUE(laser->next(scan, kPatience));
      expect_true_scan(scan);
      EXPECT_EQ(sensor.baud, change == Change::kDone ? 115200 : 19200);
    }
    stop.give();
    thread.join();
  }
}

/// A sensor in an abnormal state, until it is reset if that helps.
class AbnormalScip final : public tests::InterposedDevice {
 public:
  AbnormalScip(ByteDevice& sensor, bool reset_helps) : InterposedDevice(sensor), reset_helps_(reset_helps) {}

  void receive(ByteView bytes, double now_s) override {
    const std::string text(bytes.begin(), bytes.end());
    num_resets += text.starts_with("RS") ? 1 : 0;
    if (num_resets > 0 && reset_helps_) return hand_on(bytes, now_s);
    const std::string status = text.starts_with("RS") ? "00" : "0L";
    answer(text + status + scip_sum(status) + "\n\n");
  }

  std::atomic<int> num_resets = 0;

 private:
  bool reset_helps_;
};

TEST(ScipLaserTest, ResetsASensorInAnAbnormalState) {
  for (const bool reset_helps : {true, false}) {
    WideSensor source;
    EmulatedScip emulated({.is_paced = false}, source);
    AbnormalScip sensor(emulated, reset_helps);
    RunningDevice running(sensor);
    ScipOptions options = network(running.port());
    options.recovery.num_first_attempts = 1;
    options.reply_s = 10.0;
    const auto laser = open_scip(options);
    if (reset_helps) {
      expect_true_scans(*laser, 2, 1081);
      continue;
    }
    LaserScan scan;
    try {
      laser->next(scan, kPatience);
      ADD_FAILURE();
    } catch (const SensorFault& fault) {
      EXPECT_NE(std::string(fault.what()).find("QT with status 0L (abnormal)"), std::string::npos)
          << fault.what();
    }
  }
}

/// A port as most machines have it.
class PlainLink final : public ByteLink {
 public:
  std::size_t read(std::span<std::uint8_t> /*buffer*/, double /*timeout_s*/, const StopSignal&) override {
    return 0;
  }
  void write(ByteView /*bytes*/, const StopSignal&) override { ++num_requests; }
  void flush_input() override {}
  void set_baud(int baud) override {
    if (baud > 115200) throw UnsupportedBaud("the port cannot do this baud");
  }
  int num_requests = 0;
};

TEST(ScipClientTest, AsksForNoBaudThatThePortCannotDo) {
  PlainLink link;
  StopSignal stop;
  ScipClient client(link, 0.01, stop);
  EXPECT_THROW(client.change_baud(115200, 250000), UnsupportedBaud);
  EXPECT_EQ(link.num_requests, 0);
}

TEST(ScipScansTest, TellsDamageFromFaults) {
  ScipScans scans(two_steps());
  LaserScan scan;
  using Outcome = ScipScans::Outcome;
  const std::string echo = "MD0000000101000";
  EXPECT_EQ(scans.take({echo, "00P"}, 0.0, scan), Outcome::kOther);
  EXPECT_EQ(scans.take({"GD", "99b"}, 0.0, scan), Outcome::kDamaged);
  EXPECT_EQ(scans.take({"zz" + echo, "99b"}, 0.0, scan), Outcome::kDamaged);
  EXPECT_EQ(scans.take({}, 0.0, scan), Outcome::kOther);
  EXPECT_EQ(scans.take({echo, "99c", "00?Xg", "0?XG"}, 0.0, scan), Outcome::kDamaged);
  EXPECT_EQ(scans.take({echo, "99b"}, 0.0, scan), Outcome::kDamaged);
  EXPECT_EQ(scans.take({echo, "99b", "00?Xh", "0?X0?X" + std::string(1, scip_sum("0?X0?X"))}, 0.0, scan),
            Outcome::kDamaged);
  EXPECT_EQ(scans.take({echo, "99b", "00?Xg", "0?XG"}, 0.0, scan), Outcome::kDamaged);
  EXPECT_EQ(scans.take({echo, "50" + std::string(1, scip_sum("50"))}, 0.0, scan), Outcome::kFault);
}

}  // namespace
}  // namespace scanbed::hw
