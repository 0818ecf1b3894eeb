// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace scanbed::bench {

/// Part and whole of one run: so many of so many.
struct Share {
  int part = 0;
  int whole = 0;
};

/// A figure with the interval that holds it in 95 of 100 repetitions.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Parts of all runs over wholes of all runs (1 where the wholes are 0), with its interval from resampled
/// runs: scans of one run are no independent samples. Always the same for the same runs.
///
/// @par Source  Efron, "Bootstrap Methods: Another Look at the Jackknife", Ann. Statist. 1979; percentiles of
///              1000 resamples.
Estimate pooled_share(const std::vector<Share>& runs);

/// Middle value; 0 where there is none.
double median_of(std::vector<double> values);

}  // namespace scanbed::bench
