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

struct Pool {
  int num_scans = 0;
  Tally line;
  Tally circle;
  Tally leg;
  std::optional<TrackTally> person;
};

Pool pool(Runs runs) {
  Pool pool;
  for (const RunResult& run : runs) {
    if (!run.scores) continue;
    pool.num_scans += run.scores->num_scans;
    pool.line += run.scores->line.tally;
    pool.circle += run.scores->circle.tally;
    pool.leg += run.scores->leg.tally;
    if (!run.scores->person) continue;
    if (!pool.person) pool.person.emplace();
    *pool.person += *run.scores->person;
  }
  return pool;
}

void append_tally(std::string& out, const Tally& tally, int num_scans) {
  const double num_false = tally.num_detections - tally.num_right;
  append_format(out, "{:>8}{:>7}{:>7}", share_text(tally.num_right, tally.num_detections),
                share_text(tally.num_found, tally.num_truths),
                num_scans == 0 ? "-" : fmt::format("{:.2f}", num_false / num_scans));
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
  const Pool counts = pool(runs);
  append_format(out, "  {:<26}{:>5}", runs.front().scenario, runs.size());
  for (const Tally* tally : {&counts.line, &counts.circle, &counts.leg}) {
    append_tally(out, *tally, counts.num_scans);
  }
  const bool has_people = counts.person && counts.person->num_truths > 0;
  append_format(out, "{:>8}{:>14}  {}\n", has_people ? fmt::format("{:.3f}", counts.person->mota()) : "-",
                has_people ? fmt::format("{:.2f}", counts.person->switches_per_minute()) : "-",
                verdict(runs));
}

// A bar of a scenario and the runs that missed it.
struct Missed {
  std::string bar;
  std::optional<std::string> known_fail;
  int num_missed = 0;
  bool at_most = false;
  std::optional<double> worst;
  std::uint64_t worst_seed = 0;
};

Missed missed_need(Runs runs, std::size_t index) {
  const Need& need = runs.front().gates[index].need;
  Missed missed{.bar = fmt::format("{} {} {} {:g}{}", to_string(need.kind), need.metric.name,
                                   need.metric.at_most ? "<=" : ">=", need.bound,
                                   need.window.is_whole() ? "" : " in " + to_string(need.window)),
                .known_fail = need.known_fail,
                .at_most = need.metric.at_most};
  for (const RunResult& run : runs) {
    const GateResult& gate = run.gates.at(index);
    if (gate.met) continue;
    ++missed.num_missed;
    const bool is_worse = !missed.worst || !gate.value ||
                          (missed.at_most ? *gate.value > *missed.worst : *gate.value < *missed.worst);
    if (missed.num_missed > 1 && !is_worse) continue;
    missed.worst = gate.value;
    missed.worst_seed = run.seed;
  }
  return missed;
}

Missed missed_expectation(Runs runs, std::size_t index) {
  const Expectation& expectation = runs.front().expectations[index].expectation;
  Missed missed{.bar = expectation.text(), .known_fail = expectation.known_fail};
  for (const RunResult& run : runs) {
    const ExpectResult& result = run.expectations.at(index);
    if (result.met) continue;
    ++missed.num_missed;
    const double share =
        result.num_scans == 0 ? 0.0 : static_cast<double>(result.num_held) / result.num_scans;
    if (missed.worst && share >= *missed.worst) continue;
    missed.worst = share;
    missed.worst_seed = run.seed;
  }
  return missed;
}

void append_missed(std::string& out, Runs runs, const Missed& missed) {
  if (missed.num_missed == 0) return;
  append_format(out, "  {}: {}: missed in {} of {}, worst {} (seed {})", runs.front().scenario, missed.bar,
                missed.num_missed, runs.size(),
                missed.worst ? fmt::format("{:.4g}", *missed.worst) : "nothing", missed.worst_seed);
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
  append_format(out, "  {}: collisions in {} of {} runs; {} (seed {})\n", first->scenario,
                std::count_if(runs.begin(), runs.end(), has_some), runs.size(),
                sim::to_string(first->collisions.front()), first->seed);
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
  append_format(out, "  {:<31}{:>22}{:>22}{:>22}{:>22}\n", "", "lines   ", "circles   ", "legs   ",
                "people   ");
  append_format(out, "  {:<26}{:>5}", "scenario", "runs");
  for (int kind = 0; kind < 3; ++kind) append_format(out, "{:>8}{:>7}{:>7}", "prec.", "recall", "false");
  append_format(out, "{:>8}{:>14}\n", "MOTA", "switches/min");
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
    append_format(out, "interrupted after {} of {} runs\n", runs.size(), num_runs);
  }
  return out;
}

}  // namespace scanbed::scenarios
