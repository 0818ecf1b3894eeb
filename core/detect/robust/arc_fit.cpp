// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr int kMaxSteps = 6;
constexpr double kEnoughGain = 0.1;  // of chi squared in a step: less changes no decision
constexpr double kMinRadius_m = 0.02;
constexpr double kMaxRadius_m = 3.0;
constexpr double kMinSlant2 = 0.36;
// A silhouette lies between two beams: where exactly is uncertain by about this share of their spacing.
constexpr double kSilhouetteSpacings = 0.3;

using Lanes = Eigen::Array2d;  // two echoes at a time

struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double chi2 = 0.0;

  void add(double residual, const Eigen::Vector3d& jacobian) {
    information.noalias() += jacobian * jacobian.transpose();
    gradient += residual * jacobian;
    chi2 += residual * residual;
  }
};

/// The normal equations of the echoes; what the matrix would hold twice is added once.
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
    NormalEquations equations;
    equations.information << xx.sum(), xy.sum(), -x.sum(), xy.sum(), yy.sum(), -y.sum(), -x.sum(), -y.sum(),
        w.sum();
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

NormalEquations linearize(const Echoes& echoes, std::span<const Stretch> parts,
                          std::span<const Witness> witnesses, const Eigen::Vector3d& arc) {
  NormalEquations sum = terms_of(echoes, parts, arc).sum();
  if (!witnesses.empty()) add_silhouette(echoes, witnesses, arc, sum);
  return sum;
}

Eigen::Vector3d step_of(const NormalEquations& equations, double damping) {
  Eigen::Matrix3d damped = equations.information;
  // The same for x and y, so that a turned scan takes turned steps.
  const double place_information = 0.5 * (damped(0, 0) + damped(1, 1));
  damped.diagonal() += damping * Eigen::Vector3d(place_information, place_information, damped(2, 2));
  return -(damped.inverse() * equations.gradient);
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

std::optional<ArcFit> fit_arc(const Echoes& echoes, std::span<const Stretch> parts,
                              std::span<const Witness> witnesses, const Cylinder& start) {
  Eigen::Vector3d arc(start.center_m.x(), start.center_m.y(),
                      std::clamp(start.radius_m, 2.0 * kMinRadius_m, 0.9 * kMaxRadius_m));
  NormalEquations equations = linearize(echoes, parts, witnesses, arc);
  double damping = 1e-3;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::Vector3d candidate = arc + step_of(equations, damping);
    if (!candidate.allFinite() || candidate.z() <= kMinRadius_m / 2) {
      damping *= 10.0;
      continue;
    }
    const NormalEquations next = linearize(echoes, parts, witnesses, candidate);
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
  if (!is_plausible(arc) || !faces_sensor(echoes, parts, arc)) return std::nullopt;
  return ArcFit{{arc.head<2>(), arc.z()}, equations.chi2, equations.information};
}

}  // namespace scanbed
