// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/curve_derivatives.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "assembled_drive_contents.hpp"
#include "contact_laws.hpp"
#include "line_torques.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace adjoint {  // a named namespace, because CurveDifferentiator::Contents has members of
                     // these types

/// The contact problem in dual numbers, for one set of inputs.
struct DualDrive {
  const CoupledDrive& drive;
  const BasicCoupledGeometry<DualReal>& geometry;
  RingModel<DualReal> rings;
  DualReal amplitude;
  std::vector<DualReal> multiplier;  // of the stiffness of a tooth pair
  std::vector<DualReal> own;         // compliance in series with a contact
  struct Flank {
    BasicToothFlank<DualReal> place;
    BasicFlankShares<DualReal> shares;
  };
  mutable std::vector<std::optional<Flank>> flanks;  // made where they are needed

  DualDrive(const CoupledDrive& of, const BasicCoupledGeometry<DualReal>& g,
            RingModel<DualReal> sound_rings, const BasicContactCracks<DualReal>& cracks,
            const DualReal& cam_amplitude)
      : drive(of),
        geometry(g),
        rings(std::move(sound_rings)),
        amplitude(cam_amplitude),
        multiplier(static_cast<std::size_t>(of.contacts()), DualReal(1.0)),
        own(static_cast<std::size_t>(of.contacts()), DualReal(0.0)),
        flanks(static_cast<std::size_t>(of.contacts())) {
    for (const auto& hinge : cracks.hinges) rings.soften(hinge);
    for (const auto& soft : cracks.balls)
      own[static_cast<std::size_t>(of.ball_nearest_to(soft.position))] += soft.compliance;
    for (const auto& soft : cracks.teeth)
      if (const auto nearest = of.drive_flank_at(soft.position))
        for (const int flank : {*nearest, *nearest + of.tooth_count()})
          multiplier[static_cast<std::size_t>(flank)] *= 1 - soft.stiffness_loss;
  }

  /// A contact that is a flank.
  [[nodiscard]] const Flank& flank(int contact) const {
    auto& found = flanks[static_cast<std::size_t>(contact)];
    if (!found) {
      const int side = drive.side_of(contact);
      const auto place = flank_at(geometry, drive.position_of(contact), side);
      found = Flank{place, flank_shares(place.contact, side)};
    }
    return *found;
  }
  /// Closing of a flank per unit of rotation.
  [[nodiscard]] DualReal turn(int contact) const { return rings.turn(flank(contact).shares); }
  /// Closing of a contact on rigid rings minus its own deflection, at fixed force and rotation.
  [[nodiscard]] DualReal closing(int contact, const Equilibrium& at) const {
    const double theta = drive.position_of(contact);
    const DualReal& soft = own[static_cast<std::size_t>(contact)];
    const DualReal yields = soft * at.force[contact];
    if (contact < drive.balls())
      return free_ball(geometry, theta) + amplitude * std::cos(2 * theta) - yields;
    const auto& [place, shares] = flank(contact);
    return free_flank(geometry, rings, place, shares, theta) + turn(contact) * at.rotation - yields;
  }
  /// Force that the law of a contact gives at its closing.
  [[nodiscard]] DualReal force(int contact, const Equilibrium& at) const {
    const double u = at.closing[contact];
    if (contact < drive.balls()) return ball_force(geometry, u);
    return multiplier[static_cast<std::size_t>(contact)] *
           flank_law(geometry, flank(contact).place).force(DualReal(u));
  }
  /// The harmonics of contact forces on the rings.
  /// @param values  the same without derivatives
  [[nodiscard]] BasicForceWaves<DualReal> waves_of(const Eigen::VectorXd& forces,
                                                   const BasicForceWaves<double>& values) const {
    // The shares of the flanks may have derivatives: a column for each direction and derivative.
    constexpr auto kWidth = static_cast<Eigen::Index>(kDualWidth);
    using Row = Eigen::Matrix<double, 1, 3 * kWidth>;
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3 * kWidth>;
    const Waves& at_teeth = drive.rings().at_teeth();
    Columns even = Columns::Zero(at_teeth.cosine.rows(), 3 * kWidth);
    Columns odd = even;
    Row row;
    for (int i = drive.balls(); i < drive.contacts(); ++i) {
      if (forces[i] == 0) continue;
      const auto& shares = flank(i).shares;
      Eigen::Index column = 0;
      for (const DualReal* const share : {&shares.outward, &shares.along, &shares.higher})
        for (const double partial : share->partial) row[column++] = forces[i] * partial;
      if (row.isZero(0.0)) continue;
      const Eigen::Index tooth = (i - drive.balls()) % drive.tooth_count();
      even.noalias() += at_teeth.cosine.col(tooth) * row;
      odd.noalias() += at_teeth.sine.col(tooth) * row;
    }
    const auto with = [](const Eigen::VectorXd& value, const Columns& partials, std::size_t group) {
      BasicForceWaves<DualReal>::Vector to(value.size());
      for (Eigen::Index n = 0; n < value.size(); ++n) {
        to[n] = value[n];
        if (group == 0) continue;  // the balls press outward
        for (std::size_t k = 0; k < kDualWidth; ++k)
          to[n].partial[k] = partials(n, static_cast<Eigen::Index>((group - 1) * kDualWidth + k));
      }
      return to;
    };
    BasicForceWaves<DualReal> sums;
    for (std::size_t group = 0; group < 4; ++group) {
      sums.even[group] = with(values.even[group], even, group);
      sums.odd[group] = with(values.odd[group], odd, group);
    }
    return sums;
  }
};

/// The derivative of a linear functional a.forces + b rotation of one state with respect to any
/// number (TC-27).
class Functional {
 public:
  /// @param weight  coefficients a of the forces of all contacts
  /// @param turn    b, of the rotation
  Functional(const CoupledDrive& drive, const Equilibrium& state, const Eigen::VectorXd& weight,
             double turn)
      : Functional(drive, state, drive.linear_response(state, weight, -turn)) {}

  /// The functional of a state in which no flank touches; flanks that are about to touch are left
  /// out.
  [[nodiscard]] static Functional of_balls(const CoupledDrive& drive, const Equilibrium& state,
                                           const Eigen::VectorXd& weight) {
    CoupledDrive::Tangent adjoint = drive.linear_response(state, weight, 0.0);
    adjoint.force.tail(drive.contacts() - drive.balls()).setZero();
    adjoint.rotation = 0.0;
    return {drive, state, std::move(adjoint)};
  }
  /// The functional of the closing of one flank that does not touch, at fixed rotation.
  [[nodiscard]] static Functional of_closing(const CoupledDrive& drive, const Equilibrium& state,
                                             int flank) {
    CoupledDrive::Tangent adjoint =
        drive.linear_response(state, drive.rings().flexibility().row(flank).transpose(), 0.0);
    adjoint.force.tail(drive.contacts() - drive.balls()).setZero();
    adjoint.force *= -1.0;
    adjoint.force[flank] += 1.0;
    adjoint.rotation = 0.0;
    return {drive, state, std::move(adjoint)};
  }

  /// @param load  torque over ring radius, with its derivatives
  [[nodiscard]] DualReal derivative(const DualDrive& dual, const DualReal& load) const {
    const auto left = dual.rings.load_of(dual.waves_of(adjoint_.force, adjoint_waves_));
    const auto right = dual.rings.response_to(dual.rings.load_of(force_waves(dual)));
    DualReal sum = -left.dot(right);  // closing by the rings
    if (dual.geometry.neighbours) sum -= by_neighbours(dual, *dual.geometry.neighbours);
    DualReal missing = load;
    for (int i = 0; i < drive_.contacts(); ++i) {
      if (i >= drive_.balls() && state_.force[i] != 0) missing -= dual.turn(i) * state_.force[i];
      const double weight = adjoint_.force[i];
      if (weight == 0) continue;
      sum += weight * dual.closing(i, state_);
      if (const double k = drive_.stiffness_of(state_, i); k > 0)
        sum += weight * dual.force(i, state_) / k;
    }
    return sum - adjoint_.rotation * missing;  // (TC-27)
  }
  /// The part of the closings by neighbouring teeth (TC-31).
  [[nodiscard]] DualReal by_neighbours(const DualDrive& dual,
                                       const BasicToothNeighbours<DualReal>& neighbours) const {
    const ElasticRings& rings = drive_.rings();
    struct Push {  // force of a flank outward and along the pitch circle
      int flank = 0;
      DualReal outward;
      DualReal along;
    };
    std::vector<Push> pushes;
    for (int j = drive_.balls(); j < drive_.contacts(); ++j)
      if (const double force = state_.force[j]; force != 0)
        pushes.push_back(
            {j, force * dual.flank(j).shares.outward, force * dual.flank(j).shares.along});
    DualReal sum = 0.0;
    for (int i = drive_.balls(); i < drive_.contacts(); ++i) {
      if (adjoint_.force[i] == 0) continue;
      DualReal outward = 0.0;
      DualReal along = 0.0;
      for (const Push& push : pushes) {
        const auto moves = neighbours.between(rings.flank(i), rings.flank(push.flank));
        outward += moves.outward * push.outward + moves.mixed * push.along;
        along += moves.along * push.along - moves.mixed * push.outward;
      }
      const auto& shares = dual.flank(i).shares;
      sum += adjoint_.force[i] * (shares.outward * outward + shares.along * along);  // (TC-31)
    }
    return sum;
  }
  [[nodiscard]] const Equilibrium& state() const { return state_; }
  [[nodiscard]] BasicForceWaves<DualReal> force_waves(const DualDrive& dual) const {
    return dual.waves_of(state_.force, force_waves_);
  }

 private:
  Functional(const CoupledDrive& drive, Equilibrium state, CoupledDrive::Tangent adjoint)
      : drive_(drive),
        state_(std::move(state)),
        adjoint_(std::move(adjoint)),
        adjoint_waves_(drive.rings().waves_of(adjoint_.force)),
        force_waves_(drive.rings().waves_of(state_.force)) {}

  const CoupledDrive& drive_;
  Equilibrium state_;
  CoupledDrive::Tangent adjoint_;
  BasicForceWaves<double> adjoint_waves_;
  BasicForceWaves<double> force_waves_;
};

/// A value with the derivatives of another number.
DualReal with_derivatives(double value, DualReal derivative) {
  derivative.value = value;
  return derivative;
}

Functional of_rotation(const CoupledDrive& drive, const Equilibrium& state) {
  return {drive, state, Eigen::VectorXd::Zero(drive.contacts()), 1.0};
}

/// The rotation at which the ring rests without torque (TC-11).
class Rest {
 public:
  explicit Rest(const CoupledDrive& drive) : value_(drive.assembled().rotation) {
    const Equilibrium& state = drive.assembled();
    if (drive.largest_flank_force(state) > 0) {  // interference: the flanks hold the ring
      held_.emplace(of_rotation(drive, state));
    } else if (value_ != 0) {  // at the end of its play, where one flank touches
      for (int i = drive.balls(); i < drive.contacts(); ++i)
        if (!drive.is_lost(i) && (!touching_ || state.closing[i] > state.closing[*touching_]))
          touching_ = i;
      if (touching_) held_.emplace(Functional::of_closing(drive, state, *touching_));
    }
  }

  [[nodiscard]] DualReal rotation(const DualDrive& dual) const {
    if (!held_) return value_;
    const DualReal derivative = held_->derivative(dual, 0.0);
    if (!touching_) return with_derivatives(value_, derivative);
    return with_derivatives(value_, derivative * (-1 / dual.turn(*touching_).value));
  }

 private:
  double value_ = 0.0;
  std::optional<Functional> held_;  // absent if the ring rests inside its play, at 0
  std::optional<int> touching_;     // the flank that ends its play
};

/// One of the curves: its states at T1, T2, T3.
struct Curve {
  const CoupledDrive& drive;
  double sense = 1.0;
  Rest rest;
  std::vector<Functional> at;  // of the rotation

  Curve(const CoupledDrive& of, double of_sense, const LineTorques<double>& torques)
      : drive(of), sense(of_sense), rest(of) {
    Equilibrium state = drive.assembled();
    for (const double torque : {torques.T1 / 3, torques.T1, torques.T2, torques.T3}) {
      state = drive.solve(sense * torque, state);
      if (!state.converged) throw SolverError("no equilibrium at one of the maker's torques");
      if (torque != torques.T1 / 3) at.push_back(of_rotation(drive, state));
    }
  }

  /// @param in_series  compliance of the members in series with the ring
  [[nodiscard]] LineValues<DualReal> lines(const DualDrive& dual,
                                           const LineTorques<DualReal>& torques,
                                           const DualReal& in_series) const {
    const DualReal& R = dual.geometry.ring_radius;
    const DualReal from = rest.rotation(dual);
    const auto twist = [&](const Functional& functional, const DualReal& torque) {
      const DualReal rotation = with_derivatives(functional.state().rotation,
                                                 functional.derivative(dual, sense * torque / R));
      return sense * (rotation - from) / R + in_series * torque;  // (TC-14)
    };
    const DualReal phi1 = twist(at[0], torques.T1);
    const DualReal phi2 = twist(at[1], torques.T2);
    const DualReal phi3 = twist(at[2], torques.T3);
    return {.K1 = torques.T1 / phi1,  // (TC-14)
            .K2 = (torques.T2 - torques.T1) / (phi2 - phi1),
            .K3 = (torques.T3 - torques.T2) / (phi3 - phi2)};
  }
};

/// The cam that lifts the lobes of the sound drive to w_0 (TC-12).
class Cam {
 public:
  explicit Cam(const CoupledDrive& sound)
      : sound_(sound),
        lobe_(
            sound.largest_flank_force(sound.assembled()) > 0
                ? Functional(sound, sound.assembled(), sound.rings().lobe_of_forces(), 0.0)
                : Functional::of_balls(sound, sound.assembled(), sound.rings().lobe_of_forces())) {
    Eigen::VectorXd cam = Eigen::VectorXd::Zero(sound.contacts());
    for (int k = 0; k < sound.balls(); ++k) cam[k] = std::cos(2 * sound.position_of(k));
    rise_ = sound.rings().lobe(sound.linear_response(sound.assembled(), cam, 0.0).force);
  }

  /// @param dual  the sound drive, with an amplitude without derivatives
  [[nodiscard]] DualReal amplitude(const DualDrive& dual) const {
    const auto& rings = dual.rings;
    // The functional itself depends on the rings: mean of w over the lobes at fixed forces.
    const DualReal lifted =
        rings.lobe_load().dot(rings.response_to(rings.load_of(lobe_.force_waves(dual))));
    const DualReal missing =
        dual.geometry.radial_displacement - lifted - lobe_.derivative(dual, 0.0);
    return with_derivatives(sound_.cam_amplitude(), missing / rise_);  // (TC-27)
  }

 private:
  const CoupledDrive& sound_;
  Functional lobe_;
  double rise_ = 0.0;
};

/// Force of the ball over a crack, in the sound drive at T2.
struct BallOver {
  double position = 0.0;
  double sense = 1.0;
  Functional force;
};

}  // namespace adjoint

struct CurveDifferentiator::Contents {
  AssembledDrive drive;
  adjoint::Cam cam;
  std::vector<adjoint::BallOver> balls;
  adjoint::Curve intact;
  adjoint::Curve positive;
  adjoint::Curve negative;

  Contents(const AssembledDrive& of, const LineTorques<double>& torques)
      : drive(of),
        cam(drive.contents().sound),
        intact(drive.contents().sound, +1, torques),
        positive(drive.contents().drive, +1, torques),
        negative(drive.contents().drive, -1, torques) {
    const CoupledDrive& sound = drive.contents().sound;
    for (const SoftBall& soft : drive.contents().cracks.balls) {
      const int ball = sound.ball_nearest_to(soft.position);
      Eigen::VectorXd weight = Eigen::VectorXd::Zero(sound.contacts());
      weight[ball] = 1.0;
      const Equilibrium state = worst_of_ball(sound, torques.T2, soft.position);
      balls.push_back({soft.position, state.torque < 0 ? -1.0 : 1.0,
                       adjoint::Functional(sound, state, weight, 0.0)});
    }
  }
};

CurveDifferentiator::CurveDifferentiator(const AssembledDrive& drive) {
  const AssembledDrive::Contents& contents = drive.contents();
  require(contents.options.cage_phase == 0, "cage_phase", contents.options.cage_phase, "rad",
          "0 for derivatives, because the cam is made for a ball at the lobe (TC-12)");
  require(contents.deviations.empty(), "deviations.pairing_gap", contents.deviations.pairing_gap,
          "m", "a drive without deviations for derivatives (TC-36)");
  if (!contents.fails_because.empty()) throw SolverError(contents.fails_because);
  if (!contents.unusable_because.empty()) throw SolverError(contents.unusable_because);
  contents_ = std::make_shared<const Contents>(drive, line_torques(drive.gear(), Lift<double>()));
}

CurveDerivatives CurveDifferentiator::of(const GearSet& gear, const Lift<DualReal>& lift,
                                         const SeriesCompliance<DualReal>& series) const {
  const AssembledDrive::Contents& of_drive = contents_->drive.contents();
  const auto torques = line_torques(gear, lift);
  const auto geometry = coupled_geometry(gear, of_drive.options, lift);
  const RingModel<DualReal> rings(gear, lift, geometry, of_drive.options);
  adjoint::DualDrive sound(of_drive.sound, geometry, rings, {}, of_drive.sound.cam_amplitude());
  sound.amplitude = contents_->cam.amplitude(sound);

  const BasicBallForce<DualReal> ball_over = [&](double position) -> DualReal {
    for (const adjoint::BallOver& ball : contents_->balls) {
      if (ball.position != position) continue;
      const int number = of_drive.sound.ball_nearest_to(position);
      return adjoint::with_derivatives(
          ball.force.state().force[number],
          ball.force.derivative(sound, ball.sense * torques.T2 / geometry.ring_radius));
    }
    return 0.0;
  };
  std::vector<Note> notes;  // the assembly of the drive has already added these notes
  const auto cracks =
      acting(of_drive.sound, contact_cracks(gear, lift, geometry, ball_over, notes));
  const adjoint::DualDrive cracked(of_drive.drive, geometry, rings, cracks, sound.amplitude);

  auto members = cup_members(gear, lift);
  members.output_shaft = series.output_shaft;
  members.cracks_positive = series.positive_in_line;
  members.cracks_negative = series.negative_in_line;
  return {.intact = contents_->intact.lines(sound, torques, members.sound()),
          .positive = contents_->positive.lines(cracked, torques,
                                                members.sound() + members.cracks_positive),
          .negative = contents_->negative.lines(cracked, torques,
                                                members.sound() + members.cracks_negative)};
}

std::vector<CurveStep> curve_steps(const GearSet& gear) {
  std::vector<CurveStep> steps = {
      {"drive.ratio", "the field determines the number of teeth, which is a whole number"}};
  for_each_crack(gear, [&]<class Crack>(const std::string& path, const Crack&) {
    if constexpr (std::is_same_v<Crack, ToothCrack>)
      steps.push_back({path + ".position", "the field only selects the nearest tooth"});
    else if constexpr (requires(const Crack& crack) { crack.stress_driver; })
      steps.push_back({path + ".position", "the field only selects the nearest ball"});
  });
  return steps;
}

}  // namespace strainwave
