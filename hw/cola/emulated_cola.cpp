// SPDX-License-Identifier: MIT
#include "hw/cola/emulated_cola.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace scanbed::hw {
namespace {

constexpr RangeSensor::Seconds kPatience{1.0};
constexpr double kScanAge_s = 0.004;  // of a TiM's scan when its telegram is sent
constexpr const char* kAccessDenied = "sFA A";
constexpr const char* kUnknownMethod = "sFA 2";
constexpr const char* kUnknownVariable = "sFA 3";

std::string to_cola_hex_signed(std::int32_t value) {
  return to_cola_hex(std::bit_cast<std::uint32_t>(value));
}

std::uint32_t wrapped_us(double time_s) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(time_s * 1e6) & 0xFFFFFFFF);
}

}  // namespace

EmulatedCola::EmulatedCola(const ColaEmulatorOptions& options, RangeSensor& source)
    : options_(options), source_(source), num_polls_left_(options.num_spin_up_polls) {}

void EmulatedCola::say(const std::string& body) {
  const Bytes frame = frame_cola(body);
  out_.insert(out_.end(), frame.begin(), frame.end());
}

void EmulatedCola::receive(ByteView bytes, double now_s) {
  reader_.feed(bytes);
  for (std::string body; reader_.next(body);) answer(body, now_s);
}

void EmulatedCola::answer(const std::string& body, double now_s) {
  ColaTokens tokens(body);
  const std::string kind(tokens.next());
  const std::string name(tokens.next());
  const std::size_t used = std::min(body.size(), kind.size() + name.size() + 2);
  if (kind == "sRN") return answer_read(name, now_s);
  if (kind == "sMN") return answer_method(name, std::string_view(body).substr(used));
  if (kind == "sWN") return answer_write(name);
  if (kind == "sEN" && name == "LMDscandata") {
    is_streaming_ = tokens.next() == "1";
    next_scan_s_ = now_s;
    return say("sEA LMDscandata " + std::string(is_streaming_ ? "1" : "0"));
  }
  say("sFA C");
}

void EmulatedCola::answer_read(const std::string& name, double now_s) {
  if (name == "STlms" && options_.is_lms) {
    const bool is_up = is_measuring_ && num_polls_left_-- <= 0;
    return say(std::string("sRA STlms ") + (is_up ? "7" : "4") + " 0 8 00:00:00 A 01.01.1970 0 0 0");
  }
  if (name == "SCdevicestate") return say(std::string("sRA SCdevicestate ") + (is_logged_in_ ? "0" : "1"));
  if (name == "DeviceIdent") return say("sRA DeviceIdent 10 LMS10x_FieldEval 10 V1.36-21.10.2010");
  if (name == "LMDscandata") return say(scan_text("sRA", now_s));
  say(kUnknownVariable);
}

void EmulatedCola::answer_method(const std::string& name, std::string_view data) {
  if (name == "SetAccessMode") {
    const bool is_right = data.ends_with("F4724744") && !options_.refuses_password;
    is_logged_in_ = is_right;
    return say(is_right ? "sAN SetAccessMode 1" : "sAN SetAccessMode 0");
  }
  if (name == "Run") {
    is_logged_in_ = false;
    return say("sAN Run 1");
  }
  if (name == "LMCstartmeas" || name == "LMCstopmeas") {
    if (!is_logged_in_) return say("sFA 1");
    is_measuring_ = name == "LMCstartmeas";
    return say("sAN " + name + " 0");
  }
  say(kUnknownMethod);
}

void EmulatedCola::answer_write(const std::string& name) {
  if (!is_logged_in_) return say(kAccessDenied);
  // What a TiM sends is fixed.
  if (name == "LMDscandatacfg" && options_.is_lms) return say("sWA LMDscandatacfg");
  say(name == "LMDscandatacfg" ? "sFA 4" : kUnknownVariable);
}

bool EmulatedCola::sends(double now_s) const {
  const bool is_up = is_measuring_ && !(options_.is_lms && is_logged_in_);
  return is_streaming_ && is_up && now_s >= next_scan_s_;
}

std::string EmulatedCola::scan_text(std::string_view kind, double now_s) {
  if (!source_.next(scan_, kPatience)) scan_.range_m.assign(scan_.range_m.size(), kNoEcho);
  ++num_scans_;
  const auto count = to_cola_hex(num_scans_ & 0xFFFFU);
  const auto frequency = static_cast<std::uint32_t>(std::lround(100.0 / options_.scan_period_s));
  const auto num_values = static_cast<std::uint32_t>(
      (options_.last_angle - options_.first_angle) / static_cast<std::int32_t>(options_.step) + 1);
  std::string text(kind);
  text += " LMDscandata 1 1 107375C 0 0 " + count + " " + count + " " +
          to_cola_hex(wrapped_us(now_s - kScanAge_s)) + " " + to_cola_hex(wrapped_us(now_s)) + " 0 0 8 0 0 " +
          to_cola_hex(frequency) + " 168 0 1 DIST1 " + to_cola_hex(1.0F) + " 00000000 " +
          to_cola_hex_signed(options_.first_angle) + " " + to_cola_hex(options_.step) + " " +
          to_cola_hex(num_values);
  for (std::uint32_t i = 0; i < num_values; ++i) {
    const double angle_deg = (options_.first_angle + static_cast<double>(i) * options_.step) / 10000.0;
    const double range_m = range_towards(scan_, radians(angle_deg - 90.0));
    const double steps = std::isfinite(range_m) ? std::clamp(range_m * 1000.0, 0.0, 65535.0) : 0.0;
    text += " " + to_cola_hex(static_cast<std::uint32_t>(std::lround(steps)));
  }
  return text + " 0 0 1 B not defined 0 0 0";
}

void EmulatedCola::run(double now_s, Bytes& out) {
  if (sends(now_s)) {
    say(scan_text("sSN", now_s));
    next_scan_s_ = options_.is_paced ? std::max(next_scan_s_ + options_.scan_period_s, now_s - 1.0) : now_s;
  }
  out.insert(out.end(), out_.begin(), out_.end());
  out_.clear();
}

double EmulatedCola::next_event_s() const {
  const bool is_held_up = options_.is_lms && is_logged_in_;
  return is_streaming_ && is_measuring_ && !is_held_up ? next_scan_s_
                                                       : std::numeric_limits<double>::infinity();
}

void EmulatedCola::hang_up() {
  is_logged_in_ = is_streaming_ = false;
  num_polls_left_ = 0;
  out_.clear();
}

}  // namespace scanbed::hw
