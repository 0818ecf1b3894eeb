// SPDX-License-Identifier: MIT
#include "scenarios/report/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "scenarios/report/append_format.hpp"
#include "scenarios/report/share_text.hpp"

namespace scanbed::scenarios {
namespace {

// Runs of one scenario.
using Runs = std::span<const RunResult>;

std::vector<Runs> group(Runs results) {
  std::vector<Runs> groups;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= results.size(); ++i) {
    if (i < results.size() && results[i].scenario == results[first].scenario) continue;
    groups.push_back(results.subspan(first, i - first));
    first = i;
  }
  return groups;
}

Scores pool(Runs runs) {
  Scores pool;
  for (const RunResult& run : runs) {
    if (!run.scores) continue;
    pool.num_scans += run.scores->num_scans;
    pool.line.tally += run.scores->line.tally;
    pool.circle.tally += run.scores->circle.tally;
    pool.leg.tally += run.scores->leg.tally;
    if (!run.scores->person) continue;
    if (!pool.person) pool.person.emplace();
    *pool.person += *run.scores->person;
  }
  return pool;
}

std::string seed_text(const std::optional<std::uint64_t>& seed) {
  return seed ? fmt::format(" (seed {})", *seed) : "";
}

void append_kind(std::string& out, const KindScore& kind, const Scores& scores) {
  const Tally& tally = kind.tally;
  append_format(out, "{:>8}{:>7}{:>7}", share_text(tally.num_right, tally.num_detections),
                share_text(tally.num_found, tally.num_truths), value_text(scores.false_per_scan(kind), 2));
}

int count_refused(Runs runs) {
  return static_cast<int>(
      std::count_if(runs.begin(), runs.end(), [](const RunResult& run) { return !run.is_accepted(); }));
}

std::string verdict(Runs runs) {
  const int num_refused = count_refused(runs);
  if (num_refused > 0) return fmt::format("MISS in {} of {}", num_refused, runs.size());
  const auto num_met =
      std::count_if(runs.begin(), runs.end(), [](const RunResult& run) { return run.met_its_gates(); });
  if (num_met == static_cast<std::ptrdiff_t>(runs.size())) return "pass";
  return "known failure";
}

void append_row(std::string& out, Runs runs) {
  const Scores scores = pool(runs);
  append_format(out, "  {:<26}{:>5}", runs.front().scenario, runs.size());
  for (const KindScore* kind : {&scores.line, &scores.circle, &scores.leg}) append_kind(out, *kind, scores);
  const TrackTally people = scores.person.value_or(TrackTally{});
  append_format(out, "{:>8}{:>14}{:>7}  {}\n", value_text(people.mota(), 3),
                value_text(people.switches_per_minute(), 2),
                scores.person ? value_text(scores.false_per_scan(people), 2) : "-", verdict(runs));
}

// A bar of a scenario and the runs that missed it.
struct Missed {
  std::string bar;
  std::optional<std::string> known_fail;
  int num_missed = 0;
  std::optional<double> worst;  ///< empty: nothing was measured, which is worse than any value
  std::optional<std::uint64_t> worst_seed;

  void take(std::optional<double> value, bool is_at_most, const std::optional<std::uint64_t>& seed) {
    ++num_missed;
    const bool is_better =
        num_missed > 1 && (!worst || (value && (is_at_most ? *value <= *worst : *value >= *worst)));
    if (is_better) return;
    worst = value;
    worst_seed = seed;
  }
};

Missed missed_need(Runs runs, std::size_t index) {
  const Need& need = runs.front().gates[index].need;
  Missed missed{.bar = fmt::format("{} {} {} {:g}{}", to_string(need.kind), need.metric.name,
                                   need.metric.at_most ? "<=" : ">=", need.bound,
                                   need.window.is_whole() ? "" : " in " + to_string(need.window)),
                .known_fail = need.known_fail};
  for (const RunResult& run : runs) {
    const GateResult& gate = run.gates.at(index);
    if (!gate.met) missed.take(gate.value, need.metric.at_most, run.seed);
  }
  return missed;
}

Missed missed_expectation(Runs runs, std::size_t index) {
  const Expectation& expectation = runs.front().expectations[index].expectation;
  Missed missed{.bar = expectation.text(), .known_fail = expectation.known_fail};
  for (const RunResult& run : runs) {
    const ExpectResult& result = run.expectations.at(index);
    if (result.met) continue;
    const double share =
        result.num_scans == 0 ? 0.0 : static_cast<double>(result.num_held) / result.num_scans;
    missed.take(share, false, run.seed);
  }
  return missed;
}

void append_missed(std::string& out, Runs runs, const Missed& missed) {
  if (missed.num_missed == 0) return;
  append_format(out, "  {}: {}: missed in {} of {}, worst {}{}", runs.front().scenario, missed.bar,
                missed.num_missed, runs.size(),
                missed.worst ? fmt::format("{:.4g}", *missed.worst) : "nothing",
                seed_text(missed.worst_seed));
  const std::optional<std::string>& whole = runs.front().known_fail;
  const std::optional<std::string>& reason = missed.known_fail ? missed.known_fail : whole;
  out += reason ? "; known failure: " + *reason + "\n" : "\n";
}

// Runs that had no truth have fewer bars than the others.
void append_all_missed(std::string& out, Runs runs) {
  std::size_t num_gates = runs.front().gates.size();
  std::size_t num_expectations = runs.front().expectations.size();
  for (const RunResult& run : runs) {
    num_gates = std::min(num_gates, run.gates.size());
    num_expectations = std::min(num_expectations, run.expectations.size());
  }
  for (std::size_t i = 0; i < num_gates; ++i) append_missed(out, runs, missed_need(runs, i));
  for (std::size_t i = 0; i < num_expectations; ++i) append_missed(out, runs, missed_expectation(runs, i));
}

// The first of a scenario's collisions, and in how many runs there are some.
void append_collisions(std::string& out, Runs runs) {
  const auto has_some = [](const RunResult& run) { return !run.collisions.empty(); };
  const auto first = std::find_if(runs.begin(), runs.end(), has_some);
  if (first == runs.end()) return;
  append_format(out, "  {}: collisions in {} of {} runs; {}{}\n", first->scenario,
                std::count_if(runs.begin(), runs.end(), has_some), runs.size(),
                sim::to_string(first->collisions.front()), seed_text(first->seed));
}

// A run that was cut off has not seen all that its bars ask for: a miss of it would be made up.
std::vector<RunResult> complete(Runs results) {
  std::vector<RunResult> complete;
  std::copy_if(results.begin(), results.end(), std::back_inserter(complete),
               [](const RunResult& run) { return !run.interrupted; });
  return complete;
}

std::string summary_of_complete(Runs results) {
  if (results.empty()) return "no runs\n";
  std::string out = fmt::format("preset {}, laser {}\n", results[0].preset, results[0].laser);
  append_format(out, "  {:<31}{:>22}{:>22}{:>22}{:>29}\n", "", "lines   ", "circles   ", "legs   ",
                "people      ");
  append_format(out, "  {:<26}{:>5}", "scenario", "runs");
  for (int kind = 0; kind < 3; ++kind) append_format(out, "{:>8}{:>7}{:>7}", "prec.", "recall", "false");
  append_format(out, "{:>8}{:>14}{:>7}\n", "MOTA", "switches/min", "false");
  const std::vector<Runs> groups = group(results);
  for (const Runs& runs : groups) append_row(out, runs);
  std::string notes;
  for (const Runs& runs : groups) append_all_missed(notes, runs);
  for (const Runs& runs : groups) append_collisions(notes, runs);
  if (!notes.empty()) out += "\n" + notes;
  const int num_refused = count_refused(results);
  append_format(out, "\n{} scenario{}, {} runs: ", groups.size(), groups.size() == 1 ? "" : "s",
                results.size());
  out += num_refused == 0 ? "no gate missed that is not known to fail\n"
                          : fmt::format("{} missed a gate\n", num_refused);
  return out;
}

}  // namespace

std::string run_summary(std::span<const RunResult> results, int num_runs) {
  const std::vector<RunResult> runs = complete(results);
  std::string out = summary_of_complete(runs);
  if (static_cast<int>(runs.size()) < num_runs) {
    append_format(out, "stopped after {} of {} runs\n", runs.size(), num_runs);
  }
  return out;
}

}  // namespace scanbed::scenarios
