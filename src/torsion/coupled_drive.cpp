// SPDX-License-Identifier: Apache-2.0
#include "coupled_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "contact_laws.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Without teeth as drawn, teeth farther from a lobe are taken as out of engagement (TC-7).
constexpr double kToothSpan = pi / 4;
/// Rounding stops Newton's method where a contact just touches: after this many steps without a
/// smaller residual, a residual of this many tolerances is accepted (TC-11).
constexpr int kStalledSteps = 5;
constexpr double kStalledTolerances = 100;
/// Residual below which Newton's steps are taken in full (TC-11).
constexpr double kNear = 1e-3;

/// Places of all balls, and of the teeth near the lobes.
ContactPlaces contact_places(const CoupledGeometry& g, double cage_phase) {
  ContactPlaces places{.balls = {}, .teeth = {}, .pitches = g.teeth};
  for (int k = 0; k < g.balls; ++k)
    places.balls.push_back(cage_phase + 2 * pi * k / g.balls);  // (TC-5)
  const double span = g.tooth ? g.tooth->end() : kToothSpan;
  // With an even number of teeth both lobes have the same teeth.
  const int turn = g.teeth % 2 == 0 ? g.teeth / 2 : g.teeth;
  for (int j = 0; j < g.teeth; ++j) {
    // Rounding must not keep a tooth and leave out its mirror image.
    const int nearest = std::min(j % turn, turn - 1 - j % turn);
    if (std::abs(angle_from_lobe(places.position_of(nearest))) <= span + 1e-12)
      places.teeth.push_back(j);
  }
  return places;
}

/// All drive flanks, then all coast flanks.
std::vector<ToothFlank> flanks_at(const CoupledGeometry& g, const ContactPlaces& places) {
  std::vector<ToothFlank> flanks;
  // With an even number of teeth, those of the other lobe stand at the same angles.
  const int period = g.teeth % 2 == 0 ? g.teeth / 2 : g.teeth;
  for (const int side : {+1, -1}) {
    std::vector<std::optional<ToothFlank>> known(static_cast<std::size_t>(period));
    for (const int tooth : places.teeth) {
      auto& flank = known[static_cast<std::size_t>(tooth % period)];
      if (!flank) flank = flank_at(g, places.position_of(tooth), side);
      flanks.push_back(*flank);
    }
  }
  return flanks;
}

}  // namespace

CoupledDrive::CoupledDrive(const GearSet& gear, const CoupledGeometry& geometry,
                           const CoupledOptions& options)
    : g_(geometry), tolerance_(options.tolerance), max_iterations_(options.max_iterations) {
  const ContactPlaces places = contact_places(g_, options.cage_phase);
  tooth_count_ = static_cast<int>(places.teeth.size());
  const std::vector<ToothFlank> flanks = flanks_at(g_, places);
  std::vector<FlankShares> shares;
  for (std::size_t i = 0; i < flanks.size(); ++i)
    shares.push_back(flank_shares(flanks[i].contact, i < places.teeth.size() ? +1 : -1));
  rings_ = std::make_shared<const ElasticRings>(gear, g_, options, places, shares);
  const int count = rings_->contacts();
  free_.setZero(count);
  cam_.setZero(count);
  rotation_.setZero(count);
  multiplier_.setOnes(count);
  own_.setZero(count);
  place_balls();
  place_flanks(flanks);
  nominal_ = free_;
}

CoupledDrive CoupledDrive::deviating(const Deviations& deviations) const {
  CoupledDrive drive = *this;
  drive.free_ = nominal_;
  if (deviations.empty()) return drive;
  for (int k = 0; k < g_.balls; ++k) drive.free_[k] += ball_closing(deviations, k, position_of(k));
  for (int i = g_.balls; i < contacts(); ++i) {
    const auto [tooth, side] = rings_->flank(i);
    const FlankShares shares = shares_of(i);
    drive.free_[i] += flank_closing(deviations, tooth, side, g_.teeth,
                                    std::atan2(shares.outward, side * shares.along));
  }
  return drive;
}

CoupledDrive CoupledDrive::cracked(const ContactCracks& cracks) const {
  CoupledDrive drive = *this;
  if (!cracks.hinges.empty())
    drive.rings_ = std::make_shared<const ElasticRings>(rings_->softened(cracks.hinges));
  drive.soften_contacts(cracks);
  return drive;
}

void CoupledDrive::place_balls() {
  for (int k = 0; k < g_.balls; ++k) {
    cam_[k] = std::cos(2 * position_of(k));  // (TC-5)
    free_[k] = free_ball(g_, position_of(k));
  }
}

void CoupledDrive::place_flanks(const std::vector<ToothFlank>& flanks) {
  const RingModel<double>& model = rings_->model();
  for (int i = g_.balls; i < contacts(); ++i) {
    const ToothFlank& flank = flanks[static_cast<std::size_t>(i - g_.balls)];
    const FlankShares shares = shares_of(i);
    rotation_[i] = model.turn(shares);
    free_[i] = free_flank(g_, model, flank, shares, position_of(i));
    flanks_.push_back(flank_law(g_, flank));
  }
}

void CoupledDrive::soften_contacts(const ContactCracks& cracks) {
  for (const SoftBall& soft : cracks.balls)
    own_[ball_nearest_to(soft.position)] += soft.compliance;  // (TC-23)
  for (const SoftTooth& soft : cracks.teeth)
    if (const auto nearest = drive_flank_at(soft.position)) {
      multiplier_[*nearest] *= 1 - soft.stiffness_loss;  // (TC-21)
      multiplier_[*nearest + tooth_count_] *= 1 - soft.stiffness_loss;
    }
}

int CoupledDrive::nearest_of(int first, int count, double position) const {
  const auto distance = [&](int contact) {
    return std::abs(std::remainder(position_of(contact) - position, 2 * pi));
  };
  int nearest = first;
  for (int i = first; i < first + count; ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  return nearest;
}

std::optional<int> CoupledDrive::drive_flank_at(double position) const {
  if (tooth_count_ == 0) return std::nullopt;
  const int nearest = nearest_of(g_.balls, tooth_count_, position);
  const double distance = std::abs(std::remainder(position_of(nearest) - position, 2 * pi));
  if (distance > pi / g_.teeth * (1 + 1e-9)) return std::nullopt;  // never loaded
  return nearest;
}

CoupledDrive::Law CoupledDrive::pressed_law(int contact, double closing) const {
  if (contact < g_.balls) {
    const double force = ball_force(g_, closing);
    return {force, 1.5 * g_.ball_stiffness * std::sqrt(closing), 0.4 * force * closing};
  }
  const double m = multiplier_[contact];
  const FlankLaw& flank = flanks_[static_cast<std::size_t>(contact - g_.balls)];
  return {m * flank.force(closing), m * flank.stiffness(closing), m * flank.energy(closing)};
}

double CoupledDrive::pressed_force(int contact, double closing) const {
  if (contact < g_.balls) return ball_force(g_, closing);
  return multiplier_[contact] *
         flanks_[static_cast<std::size_t>(contact - g_.balls)].force(closing);
}

void CoupledDrive::close_rigidly(Equilibrium& state) const {
  state.system.reset();
  state.closing = free_ + amplitude_ * cam_ + state.rotation * rotation_;
  state.closing += state.elastic;
  state.closing -= own_.cwiseProduct(state.force);
}

void CoupledDrive::close(Equilibrium& state) const {
  state.elastic = rings_->closings(state.force);
  close_rigidly(state);
}

void CoupledDrive::close(Equilibrium& state, const std::vector<ContactRun>& of) const {
  state.system.reset();
  state.elastic = rings_->closings(state.force, of);
  state.closing = Eigen::VectorXd::Constant(contacts(), -g_.radial_displacement);
  for (const ContactRun& run : of) {
    const auto at = [&run](const Eigen::VectorXd& all) {
      return all.segment(run.first, run.count);
    };
    state.closing.segment(run.first, run.count) =
        at(free_) + amplitude_ * at(cam_) + state.rotation * at(rotation_) + at(state.elastic) -
        at(own_).cwiseProduct(at(state.force));
  }
}

std::vector<ContactRun> CoupledDrive::near_contacts(const Equilibrium& state) const {
  constexpr double kReach = 0.02;  // of the wave; flanks close by less over most steps of a curve
  constexpr int kBetween = 4;      // contacts that cost less than another run
  const double open = -kReach * g_.radial_displacement;
  std::vector<ContactRun> runs;
  for (int i = 0; i < contacts(); ++i) {
    if (!(state.closing[i] > open) && state.force[i] == 0) continue;
    if (runs.empty() || i > runs.back().first + runs.back().count + kBetween)
      runs.push_back({.first = i, .count = 1});
    else
      runs.back().count = i + 1 - runs.back().first;
  }
  return runs;
}

double CoupledDrive::free_travel(const Eigen::VectorXd& closing, double load) const {
  double travel = std::numeric_limits<double>::infinity();
  for (int i = g_.balls; i < contacts(); ++i)
    if (rotation_[i] * load > 0 && !is_lost(i))
      travel = std::min(travel, std::max(0.0, -closing[i] / std::abs(rotation_[i])));
  // Turn slightly farther, so the flank that touches first has a stiffness.
  return std::copysign(travel + 1e-3 * g_.radial_displacement, load);
}

double CoupledDrive::energy(const Equilibrium& state, double load) const {
  double sum = -load * state.rotation;
  for (int i = 0; i < contacts(); ++i) {
    sum += law(i, state.closing[i]).energy;
    if (state.force[i] != 0)
      sum += 0.5 * state.force[i] * (rigid_closing(i, state.rotation) - state.closing[i]);
  }
  return sum;
}

Eigen::VectorXd CoupledDrive::TouchingForces::force(double rotation, int contacts) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(contacts);
  const Eigen::VectorXd of_touching = touching(rotation);
  for (Eigen::Index p = 0; p < of_touching.size(); ++p)
    force[system.contact[static_cast<std::size_t>(p)]] = of_touching[p];
  return force;
}

std::shared_ptr<const ContactSystem> CoupledDrive::system_of(const Equilibrium& state) const {
  if (state.system) return state.system;
  auto system = std::make_shared<ContactSystem>();
  std::vector<double> stiffness;
  system->contact.reserve(static_cast<std::size_t>(contacts()));
  stiffness.reserve(static_cast<std::size_t>(contacts()));
  for (int i = 0; i < contacts(); ++i)
    if (state.closing[i] > 0)
      if (const Law at = law(i, state.closing[i]); at.stiffness > 0) {
        system->contact.push_back(i);
        stiffness.push_back(at.stiffness);
      }
  const auto m = static_cast<Eigen::Index>(system->contact.size());
  // With forces lambda = root y, the matrix 1 + root C root is well conditioned even if a contact
  // just touches and is very soft.
  Eigen::MatrixXd matrix(m, m);
  system->border.resize(m);
  system->root = Eigen::Map<const Eigen::VectorXd>(stiffness.data(), m).cwiseSqrt();
  for (Eigen::Index q = 0; q < m; ++q) {
    const int j = system->contact[static_cast<std::size_t>(q)];
    const double root = system->root[q];
    const double* const opening = &rings_->flexibility()(0, j);
    system->border[q] = root * rotation_[j];
    double* const column = &matrix(0, q);  // its lower part is factored
    for (Eigen::Index p = q; p < m; ++p)
      column[p] = opening[system->contact[static_cast<std::size_t>(p)]];
    matrix.col(q).tail(m - q).array() *= root * system->root.tail(m - q).array();
    column[q] += 1.0 + root * root * own_[j];
  }
  if (!system->factor.factor(std::move(matrix)))
    throw SolverError(
        "the contacts are not stable: their compliance is not positive (TC-11); check "
        "mesh.pair_stiffness and the cracks of the races");
  system->turned = system->border;
  system->factor.solve(system->turned);
  system->resistance = system->border.dot(system->turned);
  return system;
}

bool CoupledDrive::same_contacts(const ContactSystem& system,
                                 const Eigen::VectorXd& closing) const {
  std::size_t known = 0;
  for (int i = 0; i < contacts(); ++i) {
    if (closing[i] <= 0 || is_lost(i)) continue;
    if (known == system.contact.size() || system.contact[known] != i) return false;
    ++known;
  }
  return known == system.contact.size();
}

template <class Right>
CoupledDrive::TouchingForces CoupledDrive::forces_of(const ContactSystem& system,
                                                     const Right& right) const {
  Eigen::VectorXd wanted(system.root.size());
  for (Eigen::Index p = 0; p < wanted.size(); ++p)
    wanted[p] = right(system.contact[static_cast<std::size_t>(p)], system.root[p]);
  system.factor.solve(wanted);
  return {.system = system, .base = std::move(wanted)};
}

Equilibrium CoupledDrive::newton_step(const ContactSystem& system, const Equilibrium& state,
                                      double load, const std::vector<ContactRun>& of) const {
  const TouchingForces t = forces_of(system, [&](int i, double root) {
    return force_at(i, state.closing[i]) / root +
           root * (free_[i] + amplitude_ * cam_[i] - state.closing[i]);
  });
  Equilibrium full;
  full.torque = state.torque;
  full.rotation = state.rotation;
  // Without a flank in contact the rotation has no resistance, and the ring turns until a flank
  // touches.
  if (system.resistance > 0)
    full.rotation = t.rotation(load);
  else if (load != 0)
    full.rotation += free_travel(state.closing, load);
  full.force = t.force(full.rotation, contacts());
  close(full, of);
  return full;
}

std::optional<Equilibrium> CoupledDrive::solve_touching(const ContactSystem& system,
                                                        const Equilibrium& start,
                                                        const Eigen::VectorXd& guess,
                                                        double load) const {
  // A step costs a tenth of a factorisation, so slow steps are accepted.
  constexpr int kMostSteps = 12;
  constexpr double kSlow = 4;
  if (!(system.resistance > 0) && load != 0) return std::nullopt;  // no flank holds the ring
  const Eigen::Index m = system.root.size();
  const auto contact = [&](Eigen::Index p) { return system.contact[static_cast<std::size_t>(p)]; };
  Eigen::VectorXd closing(m);
  Eigen::VectorXd is(m);  // forces of these closings by the laws of the contacts
  Eigen::VectorXd rigid(m);
  for (Eigen::Index p = 0; p < m; ++p) {
    const int i = contact(p);
    closing[p] = guess[i];
    if (!(closing[p] > 0)) return std::nullopt;
    is[p] = force_at(i, closing[p]);
    rigid[p] = free_[i] + amplitude_ * cam_[i];
  }
  const auto in_full = [&](double rotation, const Eigen::VectorXd& force, int steps) {
    Equilibrium full;
    full.torque = start.torque;
    full.rotation = rotation;
    full.force = Eigen::VectorXd::Zero(contacts());
    for (Eigen::Index p = 0; p < m; ++p) full.force[contact(p)] = force[p];
    close(full);
    judge(full, load);
    full.iterations = steps;
    return full;
  };
  double smallest = std::numeric_limits<double>::infinity();
  for (int step = 1;; ++step) {
    TouchingForces t{
        .system = system,
        .base = is.cwiseQuotient(system.root) + system.root.cwiseProduct(rigid - closing)};
    system.factor.solve(t.base);
    const double rotation = system.resistance > 0 ? t.rotation(load) : start.rotation;
    const Eigen::VectorXd force = t.touching(rotation);
    // The step solves root (closing - closing before) = (force - is)/root (TC-11).
    closing += (force - is).cwiseQuotient(system.root.cwiseAbs2());
    double largest = 0.0;
    double error = 0.0;
    double carried = 0.0;
    for (Eigen::Index p = 0; p < m; ++p) {
      const int i = contact(p);
      if (!(closing[p] > 0)) return std::nullopt;
      is[p] = force_at(i, closing[p]);
      largest = std::max(largest, is[p]);
      error = std::max(error, std::abs(is[p] - force[p]));
      carried += is[p] * rotation_[i];
    }
    error = std::max(error, std::abs(carried - load));
    if (!(error <= kNear * largest)) return std::nullopt;
    if (error <= tolerance_ * largest || error * kSlow > smallest || step == kMostSteps)
      return in_full(rotation, force, step);
    smallest = error;
  }
}

void CoupledDrive::judge(Equilibrium& state, double load) const {
  double largest = 0.0;
  double error = 0.0;
  double carried = 0.0;
  for (int i = 0; i < contacts(); ++i) {
    if (state.closing[i] <= 0 && state.force[i] == 0) continue;
    const double is = force_at(i, state.closing[i]);
    largest = std::max(largest, is);
    error = std::max(error, std::abs(is - state.force[i]));
    carried += is * rotation_[i];
  }
  error = std::max(error, std::abs(carried - load));
  state.residual = largest > 0 ? error / largest : error;
  state.converged = error <= tolerance_ * largest || (error == 0 && load == 0);
}

double CoupledDrive::move_toward(const Equilibrium& full, Equilibrium& state, double load) const {
  constexpr double kShortest = 1e-10;  // shortest length of a step; shorter steps have no effect
  constexpr double kDescent = 1e-4;    // required share of the linear decrease (Armijo)
  constexpr double kRounding = 1e-14;  // rounding of the sum of energies
  const Eigen::VectorXd d_force = full.force - state.force;
  const Eigen::VectorXd d_elastic = full.elastic - state.elastic;
  const Eigen::VectorXd d_closing = full.closing - state.closing;
  const double d_rotation = full.rotation - state.rotation;
  const double before = energy(state, load);
  double slope = -load * d_rotation;
  for (int i = 0; i < contacts(); ++i) {
    slope += force_at(i, state.closing[i]) * d_closing[i];
    if (d_force[i] != 0)
      slope += d_force[i] * (rigid_closing(i, state.rotation) - state.closing[i]);
  }
  const double noise = kRounding * std::abs(before);
  Equilibrium moved = state;
  const auto move = [&](double step) {
    moved.force = state.force + step * d_force;
    moved.elastic = state.elastic + step * d_elastic;
    moved.closing = state.closing + step * d_closing;
    moved.rotation = state.rotation + step * d_rotation;
  };
  double step = 1.0;
  for (move(step);
       step > kShortest && energy(moved, load) > before + kDescent * step * slope + noise;
       move(step))
    step /= 2;
  state = std::move(moved);
  return step;
}

Equilibrium CoupledDrive::solve(double torque, const Equilibrium& start,
                                const Eigen::VectorXd& ahead) const {
  // (TC-11): Newton's method on the contact forces; the energy along a step decides its length,
  // except that a step is taken in full if it divides the residual by kFar, or if it leaves a
  // residual of kNear or less, the smallest so far.  The factored system of a state serves the next
  // steps too while the same contacts touch and each step divides the residual by kFast.  Near the
  // equilibrium the contacts that touch are solved alone.  The steps leave out contacts that are
  // far from touching at the start; all contacts judge the result.
  constexpr double kFast = 10;
  constexpr double kFar = 4;
  const double load = torque / g_.ring_radius;
  Equilibrium state = start;
  state.torque = torque;
  state.converged = false;
  std::shared_ptr<const ContactSystem> system = system_of(start);
  std::vector<ContactRun> seen = near_contacts(start);
  bool sees_all = false;
  const auto see_all = [&] {
    if (sees_all) return;
    seen = {{.first = 0, .count = contacts()}};
    sees_all = true;
    close(state);
  };
  double smallest = std::numeric_limits<double>::infinity();
  judge(state, load);
  state.converged = false;
  double last = state.residual;
  int stalled = 0;
  // Whether the contacts that touch alone may find the equilibrium.
  bool near = start.system != nullptr;
  for (state.iterations = 0; state.iterations < max_iterations_; ++state.iterations) {
    if (!system) system = system_of(state);
    if (load != 0 && !(system->resistance > 0)) see_all();  // for the way to the next flank
    if (near) {
      near = false;
      const Eigen::VectorXd* const guess =
          state.iterations == 0 && ahead.size() > 0 ? &ahead : &state.closing;
      if (std::optional<Equilibrium> found = solve_touching(*system, state, *guess, load)) {
        found->iterations += state.iterations;
        if (found->converged) return *std::move(found);
        // Another contact touches, or the stiffness changes.
        see_all();
        if (found->residual <= kNear && found->residual < smallest) {
          smallest = found->residual;
          state = *std::move(found);
          system = system_of(state);
        }
      }
    }
    Equilibrium full = newton_step(*system, state, load, seen);
    judge(full, load);
    if (!sees_all && full.residual <= kStalledTolerances * tolerance_) {
      see_all();
      close(full);
      judge(full, load);
    }
    const bool fast = full.residual * kFast <= smallest;
    const bool in_full = full.residual * kFar <= last;
    state.residual = full.residual;
    stalled = full.residual < smallest ? 0 : stalled + 1;
    smallest = std::min(smallest, full.residual);
    last = std::min(last, full.residual);
    if (stalled >= kStalledSteps && full.residual <= kStalledTolerances * tolerance_)
      full.converged = true;
    if (full.converged) {  // the full step satisfies the laws of the contacts
      full.iterations = state.iterations + 1;
      return full;
    }
    double share = 1.0;
    const bool close_by = stalled == 0 && full.residual <= kNear;
    if (close_by || in_full) {
      full.iterations = state.iterations;
      state = std::move(full);
      near = close_by;
    } else {
      share = move_toward(full, state, load);
    }
    state.system.reset();
    if (!fast || share < 1 || !same_contacts(*system, state.closing)) system.reset();
  }
  see_all();
  return state;
}

CoupledDrive::Tangent CoupledDrive::linear_response(const Equilibrium& state,
                                                    const Eigen::VectorXd& moved,
                                                    double load) const {
  const std::shared_ptr<const ContactSystem> system = system_of(state);
  return response_of(forces_of(*system, [&](int i, double root) { return root * moved[i]; }), load);
}

CoupledDrive::Tangent CoupledDrive::response_of(const TouchingForces& t, double load) const {
  Tangent result;
  if (t.system.resistance > 0)
    result.rotation = t.rotation(load);
  else if (load != 0)  // no flank touches: the ring turns freely
    result.rotation = std::numeric_limits<double>::infinity();
  result.force = t.force(std::isfinite(result.rotation) ? result.rotation : 0.0, contacts());
  return result;
}

CoupledDrive::Tangent CoupledDrive::tangent(const Equilibrium& state) const {
  const std::shared_ptr<const ContactSystem> system = system_of(state);
  return response_of({.system = *system, .base = Eigen::VectorXd::Zero(system->root.size())},
                     1 / g_.ring_radius);  // (TC-15)
}

Equilibrium CoupledDrive::unloaded() const {
  Equilibrium state;
  state.force = state.elastic = Eigen::VectorXd::Zero(contacts());
  return state;
}

void CoupledDrive::guess_assembled() {
  // Balls and rings deform a little.
  constexpr double kStart = 1.02;
  const double w0 = g_.radial_displacement;
  amplitude_ = kStart * w0 + g_.clearance;
  assembled_ = unloaded();
  // Forces of the balls in the shape that typical drives have, which lift the lobes by w_0.
  constexpr double kBeyond = 0.1;  // of cos 2 psi: balls press a little beyond 45 degrees
  Eigen::VectorXd force = Eigen::VectorXd::Zero(contacts());
  for (int k = 0; k < g_.balls; ++k) force[k] = std::sqrt(std::max(0.0, cam_[k] + kBeyond));
  const double lifted = rings_->lobe(force);
  if (!(lifted > 0)) return;
  force *= w0 / lifted;
  const Eigen::VectorXd elastic = rings_->closings(force);
  // The mean of the amplitudes at which the balls press so.
  double needed = 0.0;
  double weights = 0.0;
  for (int k = 0; k < g_.balls; ++k) {
    const double closing = std::cbrt(std::pow(force[k] / g_.ball_stiffness, 2));
    needed += force[k] * (closing - free_[k] - elastic[k] + own_[k] * force[k]);
    weights += force[k] * cam_[k];
  }
  const double amplitude = needed / weights;
  if (!(std::abs(amplitude - amplitude_) <= w0)) return;  // no typical drive
  amplitude_ = amplitude;
  assembled_.force = force;
  assembled_.elastic = elastic;
}

bool CoupledDrive::assemble() {
  // (TC-12)
  constexpr int kMostSteps = 50;
  constexpr double kExact = 1e-12;    // share of w_0 at which the steps end
  constexpr double kAccepted = 1e-9;  // share of w_0 accepted after the last step
  const double w0 = g_.radial_displacement;
  guess_assembled();
  double missing = w0;
  for (int step = 0; step < kMostSteps; ++step) {
    // The system of the last amplitude serves this one too.
    const std::shared_ptr<const ContactSystem> system = std::move(assembled_.system);
    close_rigidly(assembled_);
    assembled_.system = system;
    assembled_ = solve(0.0, assembled_);
    if (!assembled_.converged) return false;
    missing = w0 - rings_->lobe(assembled_.force);
    if (std::abs(missing) <= kExact * w0) break;
    assembled_.system = system_of(assembled_);
    const Tangent response = linear_response(assembled_, cam_, 0.0);
    const double rise = rings_->lobe(response.force);
    // If no ball touches yet, increase the cam by the whole missing amount.
    amplitude_ += rise > 0 ? std::clamp(missing / rise, -w0, w0) : missing;
    if (!std::isfinite(amplitude_)) return false;
  }
  if (!(std::abs(missing) <= kAccepted * w0)) return false;
  rest_nearest_to_zero();
  return true;
}

bool CoupledDrive::assemble_on(double cam_amplitude, const Equilibrium* near) {
  amplitude_ = cam_amplitude;
  Equilibrium start = near != nullptr ? *near : unloaded();
  close(start);
  assembled_ = solve(0.0, start);
  if (assembled_.converged) rest_nearest_to_zero();
  return assembled_.converged;
}

void CoupledDrive::rest_nearest_to_zero() {
  // (TC-11): without torque no flank carries load, and the ring may turn until a flank touches.
  const double negligible = 1e-10 * assembled_.force.head(g_.balls).maxCoeff();
  // rotations at which the first drive flank and the first coast flank touch
  double forward = std::numeric_limits<double>::infinity();
  double backward = -forward;
  const double at = assembled_.rotation;
  for (int i = g_.balls; i < contacts(); ++i) {
    if (is_lost(i)) continue;
    if (assembled_.force[i] > negligible) return;  // interference: the flanks hold the ring
    const double touches = at - assembled_.closing[i] / rotation_[i];
    if (rotation_[i] > 0)
      forward = std::min(forward, touches);
    else
      backward = std::max(backward, touches);
  }
  assembled_.rotation = std::min(std::max(0.0, backward), forward);
  assembled_.force.tail(contacts() - g_.balls).setZero();
  close(assembled_);
}

void CoupledDrive::add_shares(const Equilibrium& state, const Tangent& tangent,
                              std::array<double, kCurveMembers>& share) const {
  const auto add = [&](CurveMember member, double value) {
    share[static_cast<std::size_t>(member)] += value;
  };
  for (int i = 0; i < contacts(); ++i)
    if (tangent.force[i] != 0)
      add(i < g_.balls ? CurveMember::balls : CurveMember::teeth,
          tangent.force[i] * tangent.force[i] * (1 / law(i, state.closing[i]).stiffness + own_[i]));
  rings_->add_shares(coefficients_of(tangent.force), share);
  add(CurveMember::circular_spline, rings_->neighbour_energy(tangent.force));
}

}  // namespace strainwave
