// SPDX-License-Identifier: MIT
#include "hw/recording/time_order.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

#include "core/text/number_text.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kMostHeld = 4096;
constexpr double kPatience_s = 0.1;

struct Held {
  RecordedScan scan;
  std::int64_t number = 0;  // in the source
  double arrival_s = 0.0;   // by steady_now_s()
};

bool is_later(const Held& a, const Held& b) {
  return std::pair(a.scan.scan.time_s, a.number) > std::pair(b.scan.scan.time_s, b.number);
}

class TimeOrder final : public ScanSource {
 public:
  TimeOrder(std::unique_ptr<ScanSource> source, std::string name, DamageReport report)
      : source_(std::move(source)), name_(std::move(name)), report_(std::move(report)) {}

  bool read(RecordedScan& out) override {
    while (!is_over_ && held_.size() < kMostHeld && hold_next()) continue;
    if (held_.empty()) {
      if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
      return false;
    }
    std::pop_heap(held_.begin(), held_.end(), is_later);
    std::swap(out, held_.back().scan);
    std::swap(spare_, held_.back().scan);
    held_.pop_back();
    report_if_late(out.scan.time_s);
    return true;
  }

 private:
  /// False where the scan that is the next to be given has been held for long enough and none has come
  /// meanwhile.
  bool hold_next() {
    const double deadline_s = held_.empty() ? kNoDeadline_s : held_.front().arrival_s + kPatience_s;
    Arrival arrival = Arrival::kEnd;
    try {
      arrival = source_->read_until(spare_, deadline_s);
    } catch (const std::exception&) {
      failure_ = std::current_exception();
    }
    counts_ = source_->counts();
    metadata_ = source_->metadata();
    is_over_ = arrival == Arrival::kEnd;
    if (is_over_) left_out_ = source_->left_out();
    is_live_ = is_live_ || arrival == Arrival::kNothingYet;
    if (arrival != Arrival::kScan) return false;
    held_.push_back({std::move(spare_), num_read_++, steady_now_s()});
    std::push_heap(held_.begin(), held_.end(), is_later);
    return true;
  }

  void report_if_late(double time_s) {
    const bool is_late = time_s < last_s_;
    if (is_late && !std::exchange(has_reported_, true) && report_) {
      const std::string distance = std::to_string(kMostHeld) + " scans" + (is_live_ ? ", or 0.1 s," : "");
      report_(name_ + ": a scan of " + number_text(time_s) + " s stands more than " + distance +
              " behind a later one; such scans are given out of the order of time");
    }
    last_s_ = std::max(last_s_, time_s);
  }

  std::unique_ptr<ScanSource> source_;
  std::string name_;
  DamageReport report_;
  std::vector<Held> held_;  // a heap, the earliest first
  RecordedScan spare_;      // storage for the next scan
  std::int64_t num_read_ = 0;
  bool is_over_ = false;
  bool is_live_ = false;  // scans had to be waited for
  std::exception_ptr failure_;
  double last_s_ = -std::numeric_limits<double>::infinity();  // the latest given
  bool has_reported_ = false;
};

}  // namespace

std::unique_ptr<ScanSource> in_time_order(std::unique_ptr<ScanSource> source, std::string name,
                                          DamageReport report) {
  return std::make_unique<TimeOrder>(std::move(source), std::move(name), std::move(report));
}

}  // namespace scanbed::hw
