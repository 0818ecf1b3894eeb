// SPDX-License-Identifier: MIT
#include "hw/scip/emulated_scip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

#include "hw/scip/scip_text.hpp"

namespace scanbed::hw {
namespace {

constexpr RangeSensor::Seconds kPatience{1.0};
constexpr std::size_t kLongestLine = 128;

bool all_digits(const std::string& text, std::size_t from) {
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

bool asks_for_scans(const std::string& line) {
  return line.size() >= 2 && (line[0] == 'G' || line[0] == 'M') &&
         std::string_view("DSE").find(line[1]) != std::string_view::npos;
}

int number(const std::string& text, std::size_t at, std::size_t size) {
  return std::stoi(text.substr(at, size));
}

}  // namespace

EmulatedScip::EmulatedScip(const ScipEmulatorOptions& options, RangeSensor& source)
    : options_(options),
      source_(source),
      is_scip_1_(options.starts_in_scip_1),
      is_clock_mode_(options.starts_in_clock_mode) {}

void EmulatedScip::say(const std::string& text) {
  out_ += text;
}

void EmulatedScip::status(const std::string& echo, const std::string& code) {
  say(echo + "\n" + code + scip_sum(code) + "\n\n");
}

std::string EmulatedScip::stamp(double now_s) const {
  const std::string text = encode_scip(std::llround((now_s - zero_s_) * 1000.0), 4);
  return text + scip_sum(text) + "\n";
}

void EmulatedScip::receive(ByteView bytes, double now_s) {
  if (!std::exchange(has_zero_, true)) zero_s_ = now_s;
  for (const std::uint8_t byte : bytes) {
    const char c = static_cast<char>(byte);
    if (c != '\n' && c != '\r') {
      if (line_.size() < kLongestLine) line_.push_back(c);
      continue;
    }
    const std::string line = std::exchange(line_, {});
    if (!line.empty()) answer(line, now_s);
  }
}

void EmulatedScip::answer_in_scip_1(const std::string& line) {
  is_scip_1_ = line != "SCIP2.0";
  say(line + (is_scip_1_ ? "\nE\n\n" : "\n0\n\n"));
}

void EmulatedScip::answer_clock(const std::string& line, double now_s) {
  if (line == "TM0") {
    status(line, is_clock_mode_ ? "02" : "00");
    is_clock_mode_ = true;
    is_laser_on_ = is_streaming_ = false;
  } else if (line == "TM2") {
    status(line, is_clock_mode_ ? "00" : "03");
    is_clock_mode_ = false;
  } else if (line == "TM1" && is_clock_mode_) {
    say(line + "\n00P\n" + stamp(now_s) + "\n");
  } else {
    status(line, line == "TM1" ? "04" : "01");
  }
}

void EmulatedScip::answer_info(const std::string& line) {
  say(line + "\n00P\n");
  if (line == "PP") say(to_scip_info(options_.parameters));
  if (line == "VV") {
    say(scip_info_line("VEND:Hokuyo Automatic Co.,Ltd.") + scip_info_line("PROD:SOKUIKI Sensor") +
        scip_info_line("FIRM:1.0.0") + scip_info_line("PROT:SCIP 2.0") + scip_info_line("SERI:H0000001"));
  }
  if (line == "II") {
    say(scip_info_line("MODL:" + options_.parameters.model) +
        scip_info_line(is_laser_on_ ? "LASR:ON" : "LASR:OFF") +
        scip_info_line("SCSP:Initial(" + std::to_string(options_.parameters.turns_per_minute) + "[rpm])") +
        scip_info_line("MESM:IDLE") + scip_info_line("SBPS:115200[bps]") + scip_info_line("TIME:000000") +
        scip_info_line("STAT:Sensor works well."));
  }
  say("\n");
}

/// Status of a G or M command; "00" and its numbers where it is one.
std::string EmulatedScip::check(const std::string& line, Request& request) const {
  const bool is_stream = line[0] == 'M';
  const std::size_t size = is_stream ? 15 : 12;
  if (line.size() < size) return "0C";
  if (line.size() > size) return "0D";
  if (!all_digits(line, 2)) return "01";
  request = {line.substr(0, is_stream ? 13 : 12),
             number(line, 2, 4),
             number(line, 6, 4),
             std::max(1, number(line, 10, 2)),
             is_stream ? number(line, 12, 1) : 0,
             is_stream ? number(line, 13, 2) : 1};
  if (request.last > options_.parameters.last_step) return "04";
  if (request.last < request.first) return "05";
  return is_stream || is_laser_on_ ? "00" : "10";
}

void EmulatedScip::answer_scan(const std::string& line, double now_s) {
  Request request;
  const std::string code = check(line, request);
  if (code != "00" || line[0] == 'M') status(line, code);
  if (code != "00") return;
  if (line[0] == 'G') {
    say(line + "\n00P\n" + scan_text(request, now_s) + "\n");
    return;
  }
  is_laser_on_ = is_streaming_ = true;
  stream_ = request;
  next_scan_s_ = now_s + sweep_s();
}

/// Carries out a command that is answered by a status alone, and gives it.
std::string EmulatedScip::carry_out(const std::string& line, double now_s) {
  if (line == "BM") return std::exchange(is_laser_on_, true) ? "02" : "00";
  if (line == "QT" || line == "RS" || line == "RT") {
    is_laser_on_ = is_streaming_ = false;
    if (line != "QT") zero_s_ = now_s;
    return "00";
  }
  const std::string name = line.substr(0, 2);
  return name == "SS" || name == "CR" || name == "HS" ? "03" : "0E";
}

void EmulatedScip::answer_state(const std::string& line) {
  const std::string state = is_streaming_ ? "004" : "000";
  say(line + "\n00P\n" + state + scip_sum(state) + "\n\n");
}

void EmulatedScip::answer(const std::string& line, double now_s) {
  if (is_scip_1_) return answer_in_scip_1(line);
  if (line.starts_with("TM")) return answer_clock(line, now_s);
  if (is_clock_mode_) return status(line, "0E");
  if (line == "PP" || line == "VV" || line == "II") return answer_info(line);
  if (asks_for_scans(line)) return answer_scan(line, now_s);
  if (line == "%ST") return answer_state(line);
  status(line, carry_out(line, now_s));
}

int EmulatedScip::range_mm(int step) const {
  const double bearing_rad =
      (step - options_.parameters.front_step) * 2.0 * kPi / options_.parameters.steps_per_turn;
  const double range_m = range_towards(scan_, bearing_rad);
  // 1 is what a sensor says of a beam without echo.
  return std::isfinite(range_m) ? static_cast<int>(std::lround(std::clamp(range_m, 0.0, 262.0) * 1000.0)) : 1;
}

/// From step 0, which the stamp of a scan is of, to the last step, behind which the scan is sent.
double EmulatedScip::sweep_s() const {
  const ScipParameters& p = options_.parameters;
  return options_.is_paced ? p.scan_period_s() * p.last_step / p.steps_per_turn : 0.0;
}

std::string EmulatedScip::scan_text(const Request& request, double step_0_s) {
  if (!source_.next(scan_, kPatience)) scan_.range_m.assign(scan_.range_m.size(), kNoEcho);
  const bool is_short = request.text[1] == 'S';
  std::string data;
  for (int first = request.first; first <= request.last; first += request.cluster) {
    int least = range_mm(first);
    for (int step = first + 1; step < std::min(first + request.cluster, request.last + 1); ++step) {
      least = std::min(least, range_mm(step));
    }
    data += is_short ? encode_scip(std::min(least, 4095), 2) : encode_scip(least, 3);
    if (request.text[1] == 'E') data += encode_scip(1000, 3);
  }
  return stamp(step_0_s) + to_scip_blocks(data);
}

void EmulatedScip::send_scan(double now_s) {
  ++num_scans_;
  if (options_.stop_after > 0 && num_scans_ == options_.stop_after) {
    is_streaming_ = is_laser_on_ = false;
    return status(stream_.text + "00", "50");
  }
  if (stream_.num_scans > 0) --stream_.num_scans;
  std::array<char, 8> left{};
  std::snprintf(left.data(), left.size(), "%02d", stream_.num_scans % 100);
  std::string text = scan_text(stream_, now_s - sweep_s());
  const bool is_damaged = options_.damage_every > 0 && num_scans_ % options_.damage_every == 0;
  if (is_damaged) text[7] = text[7] == '0' ? '1' : '0';
  say(stream_.text + left.data() + "\n99b\n" + text + "\n");
}

void EmulatedScip::run(double now_s, Bytes& out) {
  if (is_streaming_ && now_s >= next_scan_s_) {
    const bool is_finite = stream_.num_scans > 0;
    send_scan(now_s);
    if (is_finite && stream_.num_scans == 0) is_streaming_ = is_laser_on_ = false;
    const double period_s = options_.parameters.scan_period_s() * (1 + stream_.skip);
    next_scan_s_ = options_.is_paced ? std::max(next_scan_s_ + period_s, now_s - period_s) : now_s;
  }
  out.insert(out.end(), out_.begin(), out_.end());
  out_.clear();
}

double EmulatedScip::next_event_s() const {
  return is_streaming_ ? next_scan_s_ : std::numeric_limits<double>::infinity();
}

void EmulatedScip::hang_up() {
  is_laser_on_ = is_streaming_ = false;
  line_.clear();
  out_.clear();
}

}  // namespace scanbed::hw
