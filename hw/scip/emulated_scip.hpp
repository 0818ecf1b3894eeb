// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "core/scan/range_sensor.hpp"
#include "hw/scip/scip_parameters.hpp"
#include "hw/serial/device_server.hpp"

namespace scanbed::hw {

/// How an emulated Hokuyo sensor begins, and what goes wrong with it.
struct ScipEmulatorOptions {
  ScipParameters parameters = utm_30lx();
  bool is_paced = true;           ///< false: scans as fast as they are taken
  bool starts_in_scip_1 = false;  ///< wants SCIP2.0 first
  bool starts_in_clock_mode = false;
  int damage_every = 0;         ///< every so many scans one has a wrong sum; 0: none
  std::int64_t stop_after = 0;  ///< after so many scans it reports a fault, once; 0: never
};

/// A Hokuyo sensor that speaks SCIP 2.0: VV PP II BM QT RS RT TM SS CR HS GD GS GE MD MS ME and %ST. Multiple
/// echoes (HD HE ND NE) are answered as undefined.
///
/// @par Source  Hokuyo, "Communication Protocol Specification for SCIP2.0 Standard", C-42-03320B.
class EmulatedScip final : public ByteDevice {
 public:
  /// @param source  its beams are taken by their bearing; must outlive this.
  EmulatedScip(const ScipEmulatorOptions& options, RangeSensor& source);

  void receive(ByteView bytes, double now_s) override;
  void run(double now_s, Bytes& out) override;
  double next_event_s() const override;
  void hang_up() override;

 private:
  struct Request {  // of G and M commands
    std::string text;
    int first = 0;
    int last = 0;
    int cluster = 1;
    int skip = 0;
    int num_scans = 0;
  };

  void answer(const std::string& line, double now_s);
  void answer_in_scip_1(const std::string& line);
  void answer_clock(const std::string& line, double now_s);
  void answer_info(const std::string& line);
  void answer_scan(const std::string& line, double now_s);
  void answer_state(const std::string& line);
  std::string carry_out(const std::string& line, double now_s);
  std::string check(const std::string& line, Request& request) const;
  void say(const std::string& text);
  void status(const std::string& echo, const std::string& code);
  void send_scan(double now_s);
  double sweep_s() const;
  std::string scan_text(const Request& request, double step_0_s);
  int range_mm(int step) const;
  std::string stamp(double now_s) const;

  ScipEmulatorOptions options_;
  RangeSensor& source_;
  LaserScan scan_;
  std::string line_;
  std::string out_;
  bool is_scip_1_;
  bool is_clock_mode_;
  bool is_laser_on_ = false;
  bool is_streaming_ = false;
  Request stream_;
  double next_scan_s_ = 0.0;
  double zero_s_ = 0.0;
  bool has_zero_ = false;
  std::int64_t num_scans_ = 0;
};

}  // namespace scanbed::hw
