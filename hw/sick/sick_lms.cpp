// SPDX-License-Identifier: MIT
#include "hw/sick/sick_lms.hpp"

#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/attempts.hpp"
#include "hw/serial/scan_queue.hpp"
#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/sick/lms_session.hpp"
#include "hw/sick/scan_assembler.hpp"

namespace scanbed::hw {
namespace {

constexpr double kSlice_s = 0.1;

SickOptions validated(const SickOptions& options) {
  options.validate();
  return options;
}

/// A scan's longest telegram on the wire.
double telegram_s(const SickOptions& options) {
  return (2.0 * options.variant().num_beams() + 12.0) * 10.0 / options.baud;
}

double scan_s(const ScanGeometry& geometry) {
  return geometry.timing.num_rotations * geometry.timing.rotation_s;
}

}  // namespace

struct SickLms::Impl {
  explicit Impl(const SickOptions& given);
  ~Impl();

  void end();
  void work();
  void attempt();
  bool try_again(const SensorFault& fault);
  void leave(std::optional<SerialPort>& port, double answer_s) const;
  void leave_between_attempts() const;
  void open_and_stream(SerialPort& port);
  void stream(LmsLink& link, const LmsConfiguration& configuration);
  bool handle(const WireItem& item, double arrival_s, ScanAssembler& assembler);
  void push(LaserScan& scan);
  void count(const LmsLink& link);
  void enter(const char* state);
  void give_up(std::exception_ptr reason);

  const SickOptions options;
  const ScanGeometry geometry;
  // A first scan may have begun before this did, and its time must not be negative: recordings have none.
  const double start_s = steady_now_s() - telegram_s(options) - scan_s(geometry);
  StopSignal stop;
  ScanQueue queue;

  // Of the worker alone.
  LaserScan scan;
  bool has_streamed = false;
  bool was_port_good = false;          // a port that never was there is a wrong name
  std::optional<double> first_sign_s;  // when the sensor first answered
  int num_failures = 0;
  bool gives_up = false;
  int first_found_baud = 0;
  bool may_change_baud = false;  // the sensor was, or is about to be, asked for the options' baud
  int last_good_baud;
  DecoderCounts seen;  // what this link's decoder had counted when it was last asked

  mutable std::mutex mutex;
  SickReport report;  // but for what the queue counts

  std::thread worker;
};

SickLms::Impl::Impl(const SickOptions& given)
    : options(validated(given)),
      geometry(sick_geometry(options,
                             lms_word_format(options.measuring_mode.value_or(0)).value_or(LmsWordFormat{}))),
      queue(options.max_waiting,
            options.is_lossless ? ScanQueue::Full::kWaits : ScanQueue::Full::kDropsOldest),
      last_good_baud(options.baud) {
  worker = std::thread([this] { work(); });
}

SickLms::Impl::~Impl() {
  end();
  worker.join();
}

void SickLms::Impl::end() {
  stop.give();
  queue.close();
}

void SickLms::Impl::enter(const char* state) {
  const std::lock_guard lock(mutex);
  report.state = state;
}

void SickLms::Impl::give_up(std::exception_ptr reason) {
  enter("failed");
  queue.fail(std::move(reason));
}

/// Whether a fault is one to recover from.
bool SickLms::Impl::try_again(const SensorFault& fault) {
  {
    const std::lock_guard lock(mutex);
    report.last_fault = fault.what();
    report.state = "recovering";
    ++report.num_restarts;
  }
  if (has_streamed) return true;
  if (dynamic_cast<const LmsReboot*>(&fault) != nullptr && !first_sign_s) first_sign_s = steady_now_s();
  if (first_sign_s && steady_now_s() - *first_sign_s < options.patience.boot_s) return true;
  return was_port_good && ++num_failures < options.patience.num_first_attempts;
}

void SickLms::Impl::work() {
  const Attempts attempts{.device = options.path,
                          .pause_s = options.patience.pause_s,
                          .attempt = [this] { attempt(); },
                          .may_go_on = [this](const SensorFault&) { return !gives_up; },
                          .leave = [this] { leave_between_attempts(); }};
  if (const auto reason = keep_trying(attempts, stop)) give_up(reason);
}

void SickLms::Impl::attempt() {
  enter("opening");
  std::optional<SerialPort> port;
  try {
    port.emplace(options.path);
    was_port_good = true;
    open_and_stream(*port);
  } catch (const Stopped&) {
    leave(port, options.patience.close_s);
    throw;
  } catch (const DeviceRefusal&) {
    leave(port, options.patience.ack_s);
    throw;
  } catch (const SensorFault& fault) {
    gives_up = !try_again(fault);
    if (gives_up) leave(port, options.patience.ack_s);
    throw;
  }
}

/// Leaves the sensor quiet, and at the baud that it was found at; where there was a port at all.
void SickLms::Impl::leave(std::optional<SerialPort>& port, double answer_s) const {
  if (!port) return;
  end_stream(*port, options.restore_baud && first_found_baud != port->baud() ? first_found_baud : 0,
             answer_s);
  // It may have changed over after all.
  if (!may_change_baud || !options.restore_baud || port->baud() == options.baud) return;
  try {
    port->set_baud(options.baud);
  } catch (const SensorFault&) {
    return;  // the port is gone
  }
  end_stream(*port, first_found_baud, answer_s / 2.0);
}

/// After a fault, the sensor may still stream, at the baud that it was last taken to.
void SickLms::Impl::leave_between_attempts() const {
  if (first_found_baud == 0) return;
  std::optional<SerialPort> port;
  try {
    port.emplace(options.path);
    port->set_baud(last_good_baud);
  } catch (const SensorFault&) {
    return;  // the port is gone
  }
  leave(port, options.patience.close_s);
}

void SickLms::Impl::open_and_stream(SerialPort& port) {
  LmsLink link(port, options.patience, stop);
  seen = {};
  enter("looking for the sensor");
  const LmsIdentity identity = find_lms(link, probe_order(last_good_baud));
  if (!first_sign_s) first_sign_s = steady_now_s();
  if (first_found_baud == 0) first_found_baud = identity.found_baud;
  enter("configuring");
  {
    const std::lock_guard lock(mutex);
    report.type = identity.type;
  }
  may_change_baud = identity.found_baud != options.baud;
  const LmsConfiguration configuration = start_stream(link, identity, options);
  may_change_baud = false;
  last_good_baud = options.baud;
  enter("streaming");
  stream(link, configuration);
}

void SickLms::Impl::count(const LmsLink& link) {
  const DecoderCounts now = link.decoder_counts();
  const std::lock_guard lock(mutex);
  report.num_crc_errors += now.num_crc_errors - seen.num_crc_errors;
  report.num_garbage_bytes += now.num_garbage_bytes - seen.num_garbage_bytes;
  seen = now;
}

void SickLms::Impl::stream(LmsLink& link, const LmsConfiguration& configuration) {
  const LmsWordFormat format = lms_word_format(configuration.measuring_mode()).value_or(LmsWordFormat{});
  ScanAssembler assembler(options, format, configuration.sends_indices());
  const double limit_s = options.patience.silence_s + 3.0 * telegram_s(options);
  double last_good_s = steady_now_s();
  // An emulator that waits for its host does not keep to its baud: it is read without rest. On a busy machine
  // it may also stand still in a telegram, and that is no reason to lose it.
  if (options.is_lossless) {
    link.wait_in_telegrams(options.patience.silence_s);
  } else {
    link.rest_in_telegrams();
  }
  WireItem item;
  for (double arrival_s = 0.0;;) {
    const bool has_telegram = link.next_telegram(item, kSlice_s, arrival_s);
    if (link.decoder_counts().num_garbage_bytes != seen.num_garbage_bytes) {
      assembler.forget_turns();
      count(link);
    }
    if (has_telegram && handle(item, arrival_s, assembler)) last_good_s = steady_now_s();
    if (steady_now_s() - last_good_s > limit_s) {
      throw SensorFault(SensorFault::Kind::kTimeout, options.path + ": the stream fell silent");
    }
  }
}

/// Whether the telegram was a good one of the stream.
bool SickLms::Impl::handle(const WireItem& item, double arrival_s, ScanAssembler& assembler) {
  switch (assembler.take(item.body, {arrival_s - start_s, item.num_bytes_behind}, scan)) {
    case ScanAssembler::Outcome::kScan:
      push(scan);
      return true;
    case ScanAssembler::Outcome::kPart:
      return true;
    case ScanAssembler::Outcome::kRefused:
      break;
  }
  assembler.forget_turns();
  const auto stated = parse_reply(item.body);
  const auto* type = stated ? std::get_if<TypeReply>(&stated->reply) : nullptr;
  if (type != nullptr && type->is_power_on) throw LmsReboot(options.path + ": the sensor started anew");
  const std::lock_guard lock(mutex);
  ++report.num_refused_telegrams;
  return false;
}

void SickLms::Impl::push(LaserScan& next) {
  has_streamed = true;
  {
    const std::lock_guard lock(mutex);
    report.health = next.health;
  }
  queue.push(next);
}

SickLms::SickLms(const SickOptions& options) : impl_(std::make_unique<Impl>(options)) {}

SickLms::~SickLms() = default;

const ScanGeometry& SickLms::geometry() const {
  return impl_->geometry;
}

void SickLms::stop() {
  impl_->end();
}

SickReport SickLms::report() const {
  const std::lock_guard lock(impl_->mutex);
  SickReport report = impl_->report;
  report.num_scans = impl_->queue.num_pushed();
  report.num_dropped = impl_->queue.num_dropped();
  return report;
}

bool SickLms::next(LaserScan& scan, Seconds timeout) {
  switch (impl_->queue.pop(scan, timeout)) {
    case ScanQueue::Popped::kScan:
      return true;
    case ScanQueue::Popped::kClosed:
      return false;
    case ScanQueue::Popped::kTimeout:
      break;
  }
  const SickReport now = report();
  throw SensorFault(SensorFault::Kind::kTimeout,
                    impl_->options.path + ": no scan in time while " + now.state +
                        (now.last_fault.empty() ? "" : " (before: " + now.last_fault + ")"));
}

}  // namespace scanbed::hw
