// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/scan/range_sensor.hpp"
#include "hw/cola/cola_frame.hpp"
#include "hw/serial/device_server.hpp"

namespace scanbed::hw {

struct ColaEmulatorOptions {
  bool is_lms = true;                  ///< an LMS1xx; false: a TiM, which scans by itself and knows less
  std::int32_t first_angle = -450000;  ///< ten-thousandths of a degree; 90 degrees is ahead
  std::int32_t last_angle = 2250000;
  std::uint32_t step = 5000;
  double scan_period_s = 0.02;
  bool is_paced = true;       ///< false: scans as fast as they are taken
  int num_spin_up_polls = 2;  ///< how often an LMS says that its motor is not up yet
  bool refuses_password = false;
};

/// A SICK LMS1xx or TiM that speaks CoLa A.
///
/// @par Source  SICK, "Telegram listing: Ranging sensors LMS1xx, LMS5xx, TiM5xx ...", 8014631.
class EmulatedCola final : public ByteDevice {
 public:
  /// @param source  its beams are taken by their bearing; must outlive this.
  EmulatedCola(const ColaEmulatorOptions& options, RangeSensor& source);

  void receive(ByteView bytes, double now_s) override;
  void run(double now_s, Bytes& out) override;
  double next_event_s() const override;
  void hang_up() override;

 private:
  void say(const std::string& body);
  void answer(const std::string& body, double now_s);
  void answer_read(const std::string& name, double now_s);
  void answer_method(const std::string& name, std::string_view data);
  void answer_write(const std::string& name);
  bool sends(double now_s) const;
  std::string scan_text(std::string_view kind, double now_s);

  ColaEmulatorOptions options_;
  RangeSensor& source_;
  LaserScan scan_;
  ColaReader reader_;
  Bytes out_;
  bool is_logged_in_ = false;
  bool is_measuring_ = true;
  bool is_streaming_ = false;
  int num_polls_left_;
  double next_scan_s_ = 0.0;
  std::uint32_t num_scans_ = 0;
};

}  // namespace scanbed::hw
