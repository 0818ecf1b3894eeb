// SPDX-License-Identifier: MIT
#include "hw/recording/time_order.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

namespace scanbed::hw {
namespace {

constexpr std::size_t kMostHeld = 4096;

struct Held {
  RecordedScan scan;
  std::int64_t number = 0;  // in the source
};

bool is_later(const Held& a, const Held& b) {
  return std::pair(a.scan.scan.time_s, a.number) > std::pair(b.scan.scan.time_s, b.number);
}

class TimeOrder final : public ScanSource {
 public:
  TimeOrder(std::unique_ptr<ScanSource> source, std::string name, DamageReport report)
      : source_(std::move(source)), name_(std::move(name)), report_(std::move(report)) {}

  bool read(RecordedScan& out) override {
    while (!is_over_ && held_.size() < kMostHeld) hold_next();
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
  void hold_next() {
    try {
      is_over_ = !source_->read(spare_);
    } catch (const std::exception&) {
      failure_ = std::current_exception();
      is_over_ = true;
    }
    counts_ = source_->counts();
    metadata_ = source_->metadata();
    if (is_over_) {
      left_out_ = source_->left_out();
      return;
    }
    held_.push_back({std::move(spare_), num_read_++});
    std::push_heap(held_.begin(), held_.end(), is_later);
  }

  void report_if_late(double time_s) {
    const bool is_late = time_s < last_s_;
    if (is_late && !std::exchange(has_reported_, true) && report_) {
      report_(name_ + ": a scan of " + std::to_string(time_s) + " s stands more than " +
              std::to_string(kMostHeld) +
              " scans behind a later one; such scans are given out of the order of time");
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
