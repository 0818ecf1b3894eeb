// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr int kMaxSteps = 6;
constexpr double kEnoughGain = 0.1;    // of chi squared in a step: less changes no decision
constexpr double kTrustedGain = 0.03;  // a step that promises so little keeps its promise
// Where a step promises to leave more than so many times what may be left, an arc hardly ever comes of it:
// not even of one with mixed pixels at its ends, which the next fit does without.
constexpr double kHopelessExcess = 2.0;
constexpr double kMinRadius_m = 0.02;
constexpr double kMaxRadius_m = 3.0;
constexpr double kMinSlant2 = 0.36;
// A silhouette lies between two beams: where exactly is uncertain by about this share of their spacing.
constexpr double kSilhouetteSpacings = 0.3;

using Lanes = Eigen::Array2d;  // two echoes at a time

/// Of (x, y, radius); what a symmetric matrix would hold twice is held once.
struct NormalEquations {
  double xx = 0.0, xy = 0.0, yy = 0.0, xr = 0.0, yr = 0.0, rr = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double chi2 = 0.0;

  void add(double residual, const Eigen::Vector3d& jacobian) {
    xx += jacobian.x() * jacobian.x();
    xy += jacobian.x() * jacobian.y();
    yy += jacobian.y() * jacobian.y();
    xr += jacobian.x() * jacobian.z();
    yr += jacobian.y() * jacobian.z();
    rr += jacobian.z() * jacobian.z();
    gradient += residual * jacobian;
    chi2 += residual * residual;
  }

  Eigen::Matrix3d information() const {
    Eigen::Matrix3d matrix;
    matrix << xx, xy, xr, xy, yy, yr, xr, yr, rr;
    return matrix;
  }

  // The same damping for x and y, so that a turned scan takes turned steps.
  Eigen::Vector3d step(double damping) const {
    const double more = damping * 0.5 * (xx + yy);
    const double a = xx + more;
    const double b = yy + more;
    const double c = rr + damping * rr;
    // By the adjugate, which is symmetric too.
    const Eigen::Vector3d x(b * c - yr * yr, xr * yr - xy * c, xy * yr - b * xr);
    const Eigen::Vector3d y(x.y(), a * c - xr * xr, xy * xr - a * yr);
    const Eigen::Vector3d r(x.z(), y.z(), a * b - xy * xy);
    const double determinant = a * x.x() + xy * x.y() + xr * x.z();
    return -(x * gradient.x() + y * gradient.y() + r * gradient.z()) / determinant;
  }
};

/// The normal equations of the echoes.
struct EchoTerms {
  Lanes xx = Lanes::Zero(), xy = Lanes::Zero(), yy = Lanes::Zero(), x = Lanes::Zero(), y = Lanes::Zero();
  Lanes w = Lanes::Zero(), xe = Lanes::Zero(), ye = Lanes::Zero(), e = Lanes::Zero(), ee = Lanes::Zero();

  void add(const Eigen::Vector3d& arc, const Lanes& x_m, const Lanes& y_m, const Lanes& weight_per_m2) {
    const Lanes dx_m = arc.x() - x_m;
    const Lanes dy_m = arc.y() - y_m;
    const Lanes distance_m = (dx_m * dx_m + dy_m * dy_m).sqrt().max(1e-9);
    // Both times the squared range: of the radius, and of what is left of it beside the beam's distance from
    // the centre. Their quotient is the squared sigma across the surface to that along the beam.
    const Lanes radius2 = (x_m * x_m + y_m * y_m) * (arc.z() * arc.z());
    const Lanes beside = arc.x() * y_m - arc.y() * x_m;
    const Lanes facing2 = (radius2 - beside * beside).max(kMinSlant2 * radius2);
    const Lanes inverse = 1.0 / (distance_m * facing2);
    const Lanes nx = dx_m * (facing2 * inverse);
    const Lanes ny = dy_m * (facing2 * inverse);
    const Lanes weight = weight_per_m2 * radius2 * (distance_m * inverse);
    const Lanes error_m = distance_m - arc.z();
    const Lanes wx = weight * nx;
    const Lanes wy = weight * ny;
    const Lanes we = weight * error_m;
    xx += wx * nx;
    xy += wx * ny;
    yy += wy * ny;
    x += wx;
    y += wy;
    w += weight;
    xe += wx * error_m;
    ye += wy * error_m;
    e += we;
    ee += we * error_m;
  }

  NormalEquations sum() const {
    NormalEquations equations{xx.sum(), xy.sum(), yy.sum(), -x.sum(), -y.sum(), w.sum()};
    equations.gradient << xe.sum(), ye.sum(), -e.sum();
    equations.chi2 = ee.sum();
    return equations;
  }
};

EchoTerms terms_of(const Echoes& echoes, std::span<const Stretch> parts, const Eigen::Vector3d& arc) {
  EchoTerms terms;
  for (const Stretch& part : parts) {
    int k = part.first;
    for (; k < part.last; k += 2) {
      terms.add(arc, Eigen::Map<const Lanes>(&echoes.x_m[k]), Eigen::Map<const Lanes>(&echoes.y_m[k]),
                Eigen::Map<const Lanes>(&echoes.weight_per_m2[k]));
    }
    if (k > part.last) continue;
    terms.add(arc, Lanes::Constant(echoes.x_m[k]), Lanes::Constant(echoes.y_m[k]),
              Lanes(echoes.weight_per_m2[k], 0.0));
  }
  return terms;
}

void add_silhouette(const Echoes& echoes, std::span<const Witness> witnesses, const Eigen::Vector3d& arc,
                    NormalEquations& sum) {
  const double spacing_m = arc.head<2>().norm() * echoes.step_rad;
  const double weight = 1.0 / (kSilhouetteSpacings * spacing_m + 0.5 * echoes.range_noise_m);
  for (const Witness& witness : witnesses) {
    const double beside_m = arc.y() * witness.ux - arc.x() * witness.uy;
    const double sign = beside_m < 0.0 ? -1.0 : 1.0;
    const double overlap_m = arc.z() - std::abs(beside_m);
    if (overlap_m <= 0.0) continue;
    sum.add(overlap_m * weight, weight * Eigen::Vector3d(sign * witness.uy, -sign * witness.ux, 1.0));
  }
}

NormalEquations linearize(const Echoes& echoes, const ArcEvidence& evidence, const Eigen::Vector3d& arc) {
  NormalEquations sum = terms_of(echoes, evidence.parts, arc).sum();
  if (!evidence.witnesses.empty()) add_silhouette(echoes, evidence.witnesses, arc, sum);
  return sum;
}

bool is_possible(const Eigen::Vector3d& arc) {
  return arc.allFinite() && arc.z() > kMinRadius_m / 2;
}

bool is_plausible(const Eigen::Vector3d& arc) {
  return arc.allFinite() && arc.z() > kMinRadius_m && arc.z() < kMaxRadius_m &&
         arc.head<2>().norm() > arc.z();
}

// The echoes must lie on the side that faces the sensor.
bool faces_sensor(const Echoes& echoes, std::span<const Stretch> parts, const Eigen::Vector3d& arc) {
  int num_before = 0;
  for (const Stretch& part : parts) num_before += part.size();
  num_before /= 2;
  int middle = parts[0].first + num_before;
  if (middle > parts[0].last) middle = parts[1].first + num_before - parts[0].size();
  return (echoes.point_m(middle) - arc.head<2>()).dot(arc.head<2>()) < 0.0;
}

bool is_arc_of(const Echoes& echoes, std::span<const Stretch> parts, const Eigen::Vector3d& arc) {
  return is_plausible(arc) && faces_sensor(echoes, parts, arc);
}

}  // namespace

double ArcFit::squared_residual(const Echoes& echoes, int k) const {
  const Eigen::Vector2d p_m = echoes.point_m(k);
  const auto& [center_m, radius_m] = cylinder;
  const double error_m = (p_m - center_m).norm() - radius_m;
  const double radius2 = p_m.squaredNorm() * radius_m * radius_m;
  const double beside = center_m.x() * p_m.y() - center_m.y() * p_m.x();
  const double facing2 = std::max(kMinSlant2 * radius2, radius2 - beside * beside);
  return error_m * error_m * echoes.weight_per_m2[k] * radius2 / facing2;
}

std::optional<Eigen::Matrix3d> ArcFit::covariance() const {
  Eigen::Matrix3d inverse;
  bool is_known = false;
  information.computeInverseWithCheck(inverse, is_known);
  if (!is_known || !(inverse.diagonal().minCoeff() > 0.0)) return std::nullopt;
  return inverse;
}

std::optional<ArcFit> fit_arc(const Echoes& echoes, const ArcEvidence& evidence, const Cylinder& start,
                              double most_chi2) {
  Eigen::Vector3d arc(start.center_m.x(), start.center_m.y(),
                      std::clamp(start.radius_m, 2.0 * kMinRadius_m, 0.9 * kMaxRadius_m));
  NormalEquations equations = linearize(echoes, evidence, arc);
  double damping = 1e-3;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Eigen::Vector3d step = equations.step(damping);
    const Eigen::Vector3d candidate = arc + step;
    if (!is_possible(candidate)) {
      damping *= 10.0;
      continue;
    }
    const double promised_gain = -equations.gradient.dot(step);
    if (equations.chi2 - promised_gain > kHopelessExcess * most_chi2) return std::nullopt;
    if (promised_gain < kTrustedGain) {
      arc = candidate;
      equations.chi2 = std::max(0.0, equations.chi2 - promised_gain);
      break;
    }
    const NormalEquations next = linearize(echoes, evidence, candidate);
    const double gain = equations.chi2 - next.chi2;
    if (!(gain >= 0.0)) {
      // The weights move with the cylinder, so that at its least chi squared a step may lose a little.
      if (gain > -kEnoughGain) break;
      damping *= 10.0;
      continue;
    }
    arc = candidate;
    equations = next;
    damping *= 0.2;
    if (gain < kEnoughGain) break;
  }
  if (!is_arc_of(echoes, evidence.parts, arc)) return std::nullopt;
  return ArcFit{{arc.head<2>(), arc.z()}, equations.chi2, equations.information()};
}

}  // namespace scanbed
