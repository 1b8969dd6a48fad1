// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/accuracy_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <utility>

#include "drawn_drive.hpp"
#include "scatter_law.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/frequency_response.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "vibrating_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr std::uint64_t kAccuracySeed = 20240608;
constexpr int kTorquesOfTurn = 5;  // at which the gains over a turn are read

/// What a budget is computed for.
struct BudgetAt {
  double torque = 0.0;  ///< external [N*m]
  double speed = 0.0;   ///< of the input [rad/s]
};

/// The parts of the error of one drive.
struct DriveBudget {
  AngleRange wind_up;
  AngleRange kinematic;
  std::optional<double> hysteresis = {};  ///< loss at zero torque [rad]
  double lost_motion = 0.0;
  std::vector<double> gains = {};  ///< the largest over a turn of the output
  /// lowest and highest resonance with locked input over a turn of the output [Hz]; 0: not asked
  double lowest_resonance = 0.0;
  double highest_resonance = 0.0;

  [[nodiscard]] AngleRange loss() const {
    const double half = hysteresis.value_or(0.0) / 2;
    return {-half, half};
  }
  /// Linear sum (DY-16).
  [[nodiscard]] AngleRange worst_case() const {
    return {wind_up.least + kinematic.least + loss().least,
            wind_up.largest + kinematic.largest + loss().largest};
  }
  /// Root of squares of the half ranges about the sum of the middles (DY-16).
  [[nodiscard]] AngleRange root_of_squares() const {
    const double middle = wind_up.middle() + kinematic.middle();
    const double half =
        std::hypot(wind_up.peak_to_valley() / 2, kinematic.peak_to_valley() / 2, loss().largest);
    return {middle - half, middle + half};
  }
  [[nodiscard]] AngleRange of(BudgetItem item) const {
    switch (item) {
      case BudgetItem::wind_up:
        return wind_up;
      case BudgetItem::kinematic_error:
        return kinematic;
      case BudgetItem::hysteresis:
        return loss();
      case BudgetItem::worst_case:
        return worst_case();
      case BudgetItem::root_of_squares:
        break;
    }
    return root_of_squares();
  }
};

/// Compliance of the output shaft with the cracks that a torque opens [rad/(N*m)].
double shaft_compliance(const GearSet& gear, double torque) {
  if (!gear.output_shaft) return 0.0;
  const MemberCompliance of = output_shaft_compliance(gear);
  double sum = of.intact;
  for (const CrackReport& crack : of.cracks)
    sum += (torque >= 0 ? crack.positive : crack.negative).at_output.value;
  return sum;
}

/// Twist of the output by a torque on it (DY-15) [rad].
/// @param drive  null: by the sum of the members
double output_twist(const GearSet& gear, const AssembledDrive* drive, double torque) {
  if (torque == 0) return 0.0;
  if (drive == nullptr) return torque / vibrating_drive(gear, torque).stiffness();
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  const double at_flexspline = step * torque;
  const double twist = twists(*drive, std::array{at_flexspline})[0];
  if (gear.drivetrain->fixed == FixedMember::circular_spline) return twist;
  return step * (twist - shaft_compliance(gear, at_flexspline) * at_flexspline) +
         shaft_compliance(gear, torque) * torque;  // (DY-15)
}

/// Loss at zero torque of the output (DY-15) [rad].
/// @param largest  torque of the flexspline in the loop [N*m]
double hysteresis_at_output(const GearSet& gear, const AssembledDrive& drive, double largest) {
  if (gear.drivetrain->fixed == FixedMember::circular_spline)
    return Hysteresis(drive, largest).loss_at_zero().total();
  const double step =
      std::abs(flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio));
  // The friction of seals and output bearing acts on the output.
  const double friction = gear.rating ? gear.rating->friction_torque : 0.0;
  GearSet at_flexspline = gear;
  if (at_flexspline.rating) at_flexspline.rating->friction_torque = step * friction;
  const double loss = Hysteresis(at_flexspline, largest).loss_at_zero().total();
  const double of_shaft = (shaft_compliance(gear, friction) + shaft_compliance(gear, -friction));
  return step * (loss - of_shaft * step * friction) + of_shaft * friction;  // (DY-15)
}

/// Torques on the output over a turn (DY-15).
struct TorqueRange {
  double least = 0.0;
  double largest = 0.0;
};
TorqueRange torques_over_turn(const GearSet& gear, double torque) {
  const double gravity = std::abs(gear.drivetrain->gravity_torque);
  return {torque - gravity, torque + gravity};  // (DY-15)
}

/// Torques about which the springs are linear, one by one: those of a turn of the output, beginning
/// with the torque of the lost motion.  Below it flanks begin to touch, and friction holds the
/// output.
std::vector<double> linear_about(const GearSet& gear, double torque) {
  const TorqueRange range = torques_over_turn(gear, torque);
  const double smallest = makers_torques(gear).lost_motion;
  if (range.least == range.largest)
    return {std::abs(torque) > smallest ? torque : std::copysign(smallest, torque)};
  std::vector<double> torques;
  const auto add = [&](double of) {
    if (of >= range.least && of <= range.largest) torques.push_back(of);
  };
  for (int n = 0; n < kTorquesOfTurn; ++n) {
    const double of = range.least + (range.largest - range.least) * n / (kTorquesOfTurn - 1);
    if (std::abs(of) > smallest) add(of);
  }
  add(smallest);
  add(-smallest);
  if (torques.empty()) torques.push_back(smallest);
  return torques;
}

/// The load's angle per kinematic error at the speed, about one torque (DY-14).
struct GainsAt {
  std::vector<std::complex<double>> gains;  ///< of each order
  double resonance = 0.0;                   ///< the lowest, with locked input [Hz]
};

std::vector<GainsAt> gains_of(const GearSet& gear, const BudgetAt& at) {
  const KinematicError error = kinematic_error_of(gear);
  const std::vector<std::complex<double>> rigid(error.orders().size(), 1.0);
  if (at.speed == 0 || rigid.empty()) return {{.gains = rigid}};
  std::vector<double> frequencies;
  for (const ErrorOrder& of : error.orders())
    frequencies.push_back(of.order * std::abs(at.speed) / (2 * pi));
  std::vector<GainsAt> made;
  for (const double torque : linear_about(gear, at.torque)) {
    const VibratingDrive drive = vibrating_drive(gear, torque);
    const std::array paths = {ChainPath{
        .by = ShakenBy::twist, .at = drive.made.error_spring, .inertia = drive.made.load}};
    GainsAt& here = made.emplace_back();
    here.gains =
        frequency_responses(drive.made.chain, paths, frequencies, drive.held(MotorGives::speed))[0];
    for (std::complex<double>& gain : here.gains) {
      gain *= drive.made.error_twist;
      // A motor that turns back passes the phases in the other order.
      if (at.speed < 0) gain = std::conj(gain);
    }
    const std::vector<ChainMode> modes = drive.modes(MotorGives::speed);
    if (!modes.empty()) here.resonance = modes.front().frequency;
  }
  return made;
}

/// Turns of the input over which the kinematic error is judged: one of the output.
double judged_turns(const GearSet& gear) {
  return std::abs(signed_ratio(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio));
}

/// The kinematic error as the load shows it (DY-14).
AngleRange error_at_load(const GearSet& gear, const std::vector<std::complex<double>>& gains) {
  std::vector<ErrorOrder> orders = kinematic_error_of(gear).orders();
  for (std::size_t n = 0; n < gains.size(); ++n) {
    orders[n].amplitude *= std::abs(gains[n]);
    orders[n].phase += std::arg(gains[n]);
    if (!(orders[n].amplitude < kLargestError))
      throw SolverError(fmt::format(
          "the kinematic error of the order {} moves the load by more than 0.5 deg at this speed; "
          "choose another speed, or give drivetrain.gear_damping",
          shown_number(orders[n].order, 4)));
  }
  return error_range(std::move(orders), judged_turns(gear));
}

DriveBudget budget_of(const GearSet& gear, const BudgetAt& at) {
  DriveBudget budget;
  const bool coupled = missing_for_torsion_curve(gear).empty();
  std::optional<AssembledDrive> drive;
  if (coupled) drive.emplace(gear);
  const AssembledDrive* const assembled = drive ? &*drive : nullptr;
  const TorqueRange torques = torques_over_turn(gear, at.torque);
  budget.wind_up = {output_twist(gear, assembled, torques.least),
                    output_twist(gear, assembled, torques.largest)};
  budget.gains.assign(kinematic_error_of(gear).orders().size(), 0.0);
  bool first = true;
  for (const GainsAt& here : gains_of(gear, at)) {
    for (std::size_t n = 0; n < here.gains.size(); ++n)
      budget.gains[n] = std::max(budget.gains[n], std::abs(here.gains[n]));
    const AngleRange of = error_at_load(gear, here.gains);
    budget.kinematic = first ? of
                             : AngleRange{std::min(budget.kinematic.least, of.least),
                                          std::max(budget.kinematic.largest, of.largest)};
    budget.lowest_resonance =
        first ? here.resonance : std::min(budget.lowest_resonance, here.resonance);
    budget.highest_resonance = std::max(budget.highest_resonance, here.resonance);
    first = false;
  }
  const MakersTorques makers = makers_torques(gear);
  budget.lost_motion = output_twist(gear, assembled, makers.lost_motion) -
                       output_twist(gear, assembled, -makers.lost_motion);  // (TC-18)
  if (assembled != nullptr)
    budget.hysteresis = hysteresis_at_output(gear, *assembled, makers.rated);
  return budget;
}

AngleBand band_of(std::vector<double> values) {
  const auto [least, largest] = std::ranges::minmax(values);
  return {.least = least,
          .low = quantile(values, 0.05),
          .median = quantile(values, 0.5),
          .high = quantile(values, 0.95),
          .largest = largest};
}

/// A number that the file lets scatter or vary in a range.
struct DrawnInput {
  std::string path;
  std::optional<ScatterLaw> law = {};  ///< absent: uniform between the limits
  double lower = 0.0;
  double upper = 0.0;
};

std::vector<DrawnInput> drawn_inputs(const GearSet& gear) {
  std::vector<DrawnInput> inputs;
  for (const InputScatter& scatter : gear.scatter)
    inputs.push_back(
        {.path = scatter.path, .law = ScatterLaw(scatter, number_at(gear, scatter.path).value)});
  for (const InputRange& range : gear.range) {
    // A number with both has the scatter.
    if (std::ranges::find(inputs, range.path, &DrawnInput::path) != inputs.end()) continue;
    const std::string_view unit = number_at(gear, range.path).field.unit;
    inputs.push_back({.path = range.path,
                      .lower = parse_quantity("lower", range.lower, unit),
                      .upper = parse_quantity("upper", range.upper, unit)});
  }
  return inputs;
}

/// Values of the inputs in one draw (SN-8): of those that scatter, which come first, by their
/// correlated normal variables, and of the others between their limits.
void draw_values(const std::vector<DrawnInput>& inputs, const CorrelatedNormals& normals,
                 std::size_t draw, DrawnDrive& drive) {
  std::vector<double> z(normals.size());
  counter_normals(kAccuracySeed, draw, z);
  normals.correlate(z);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const DrawnInput& input = inputs[i];
    drive.number(i) = input.law ? input.law->at(z[i])
                                : input.lower + (input.upper - input.lower) *
                                                    counter_uniform(kAccuracySeed, draw, i);
  }
}

/// The largest speed of the manoeuvres, 0 without one.
double fastest(const GearSet& gear) {
  double most = 0.0;
  for (const Manoeuvre& piece : gear.manoeuvre)
    if (piece.input_speed && std::abs(*piece.input_speed) > std::abs(most))
      most = *piece.input_speed;
  return most;
}

std::optional<AccuracyBands> bands_of(const GearSet& gear, const AccuracyOptions& options,
                                      const Progress& progress) {
  const std::vector<DrawnInput> inputs = drawn_inputs(gear);
  if (inputs.empty() || options.draws == 0) return std::nullopt;
  const CorrelatedNormals normals = scattering_normals(gear);
  const auto draws = static_cast<std::size_t>(options.draws);
  std::vector<std::optional<DriveBudget>> budgets(draws);
  for_each_index(draws, {.threads = options.threads}, progress, [&] {
    return [&, drawn = std::make_unique<DrawnDrive>(gear, inputs)](std::size_t n) {
      draw_values(inputs, normals, n, *drawn);
      try {
        check(drawn->gear());
        // The torque of the load may be drawn too.
        const double torque = options.torque.value_or(drawn->gear().load.torque);
        // So may the speeds of the manoeuvres.
        const double speed = options.speed.value_or(fastest(drawn->gear()));
        budgets[n] = budget_of(drawn->gear(), {.torque = torque, .speed = speed});
      } catch (const Error&) {  // this combination breaks a rule or has no equilibrium
      }
    };
  });
  const auto rejected = std::erase(budgets, std::nullopt);
  if (budgets.empty())
    throw SolverError("none of the drives drawn from the ranges and scatters has a budget");
  std::vector<double> worst;
  std::vector<double> likely;
  for (const std::optional<DriveBudget>& budget : budgets) {
    worst.push_back(budget->worst_case().magnitude());
    likely.push_back(budget->root_of_squares().magnitude());
  }
  const auto scatters = static_cast<int>(gear.scatter.size());
  return AccuracyBands{.worst_case = band_of(std::move(worst)),
                       .root_of_squares = band_of(std::move(likely)),
                       .ranges = static_cast<int>(inputs.size()) - scatters,
                       .scatters = scatters,
                       .correlations = static_cast<int>(gear.correlation.size()),
                       .draws = static_cast<int>(budgets.size()),
                       .rejected = static_cast<int>(rejected)};
}

void note_budget(const GearSet& gear, AccuracyReport& report) {
  if (kinematic_error_of(gear).orders().empty())
    report.notes.push_back(
        {"accuracy.no_kinematic_error",
         "the file gives no kinematic error, so the budget has none; makers state about 1 arcmin "
         "from peak to valley",
         "kinematic_error", "DY-14", Severity::care,
         "Give [[kinematic_error]] with order and amplitude."});
  if (std::optional<Note> left_out = error_table_note(gear))
    report.notes.push_back(*std::move(left_out));
  if (!report.intact_hysteresis)
    report.notes.push_back(
        {"accuracy.no_hysteresis",
         "the sum of the members has no hysteresis, so the budget has none, and its wind-up is too "
         "small by a factor of 2 to 5",
         "mesh", "DY-16", Severity::care,
         "Give what strainwave torsion needs; the command says what is missing."});
  if (report.intact_hysteresis && (!gear.rating || gear.rating->friction_torque == 0))
    report.notes.push_back({"accuracy.no_friction",
                            "grease and seals cause most of the hysteresis that makers state, and "
                            "the output's part of "
                            "them is rating.friction_torque, which is 0",
                            "rating.friction_torque", "TC-17", Severity::care,
                            "Give rating.friction_torque."});
  if (gear.drivetrain->hysteresis || !gear.drivetrain->slip_element.empty()) {
    const std::string path =
        gear.drivetrain->hysteresis ? "drivetrain.hysteresis" : "drivetrain.slip_element";
    report.notes.push_back(
        {"accuracy.own_hysteresis",
         path + " is left out; the hysteresis of the budget is the loss at zero torque of the "
                "coupled drive",
         path, "DY-16", Severity::information,
         "Run strainwave simulate for a motion with " + path + "."});
  }
  if (gear.drivetrain->load_friction && (!gear.rating || gear.rating->friction_torque == 0))
    report.notes.push_back(
        {"accuracy.no_load_friction",
         "drivetrain.load_friction is left out; a load that sticks may hold the drive wound up by "
         "this torque",
         "drivetrain.load_friction", "DY-16", Severity::care,
         "Give the torque as rating.friction_torque for the budget, which contains it as "
         "hysteresis; a motion takes drivetrain.load_friction, so leave rating.friction_torque out "
         "there."});
  if (gear.drivetrain->servo)
    report.notes.push_back({"accuracy.no_servo",
                            "the controller is left out, so its lag is not in the budget",
                            "drivetrain.servo", "DY-16", Severity::care,
                            "Run strainwave simulate, which states the largest lag of the input."});
  if (gear.drivetrain->breathing == CrackBreathing::turn)
    report.notes.push_back(
        {"accuracy.no_breathing",
         "cracks stay open here while the torque opens them; that the turn closes them is left out",
         "drivetrain.breathing", "DY-15", Severity::information,
         "Run strainwave simulate, whose cracks open over the turn."});
  if (report.bands && report.bands->rejected > 0)
    report.notes.push_back(
        {"accuracy.rejected",
         fmt::format("{} of {} drawn drives break a rule, have no equilibrium or stand at a "
                     "resonance, and are left out of the bands, which may be too narrow",
                     report.bands->rejected, report.bands->rejected + report.bands->draws),
         "range", "DY-16", Severity::care, "Check the [[range]] and [[scatter]] entries."});
}

}  // namespace

AccuracyReport accuracy_report(const GearSet& gear, const AccuracyOptions& options,
                               const Progress& progress) {
  require(options.draws >= 0 && options.draws <= kMostAccuracyDraws, "--draws",
          static_cast<double>(options.draws), "1", "from 0 to 100000");
  if (options.tool_radius)
    require(*options.tool_radius > 0 && std::isfinite(*options.tool_radius), "--tool-radius",
            *options.tool_radius, "m", "> 0");
  if (options.speed)
    require(std::isfinite(*options.speed), "--speed", *options.speed, "rad/s", "a finite number");
  if (options.torque)
    require(std::isfinite(*options.torque), "--torque", *options.torque, "N*m", "a finite number");
  check(gear);
  if (!gear.drivetrain)
    throw InputError("drivetrain",
                     "must be given for the accuracy; give [drivetrain] with motor_inertia and "
                     "load_inertia");
  const bool coupled = missing_for_torsion_curve(gear).empty();
  AccuracyReport report;
  report.torque = options.torque.value_or(gear.load.torque);
  report.springs = coupled ? SpringModel::coupled_drive : SpringModel::members;
  report.speed = options.speed.value_or(fastest(gear));
  report.tool_radius = options.tool_radius;
  const BudgetAt at{.torque = report.torque, .speed = report.speed};
  const TorqueRange torques = torques_over_turn(gear, at.torque);
  report.least_torque = torques.least;
  report.largest_torque = torques.largest;
  const Drivetrain& train = *gear.drivetrain;
  if (train.gravity_torque != 0) {
    const bool positive = (at.torque >= 0) == (train.gravity_torque > 0);
    report.worst_angle = train.gravity_angle + (positive ? -pi / 2 : pi / 2);  // (DY-15)
  }
  const KinematicError error = kinematic_error_of(gear);
  report.kinematic_range = error_range(error, judged_turns(gear)).peak_to_valley();
  report.kinematic_sum = sum_of_ranges(error);

  const DriveBudget intact = budget_of(without_cracks(gear), at);
  progress.at(0.1);
  std::vector<std::string> paths;
  for_each_crack(gear, [&](const std::string& path, const auto&) { paths.push_back(path); });
  std::optional<DriveBudget> cracked;
  if (!paths.empty()) cracked = budget_of(gear, at);
  report.intact_lost_motion = intact.lost_motion;
  report.intact_hysteresis = intact.hysteresis;
  if (cracked) {
    report.cracked_lost_motion = cracked->lost_motion;
    report.cracked_hysteresis = cracked->hysteresis;
  }
  for (std::size_t n = 0; n < kBudgetItems; ++n) {
    const auto item = static_cast<BudgetItem>(n);
    report.budget.push_back({.item = item,
                             .intact = intact.of(item),
                             .cracked = cracked ? std::optional(cracked->of(item)) : std::nullopt,
                             .tool_radius = options.tool_radius});
  }
  for (std::size_t n = 0; n < error.orders().size(); ++n) {
    const ErrorOrder& of = error.orders()[n];
    report.orders.push_back(
        {.order = of.order,
         .amplitude = of.amplitude,
         .frequency = of.order * std::abs(at.speed) / (2 * pi),
         .intact_gain = intact.gains[n],
         .cracked_gain = cracked ? std::optional(cracked->gains[n]) : std::nullopt});
  }
  progress.at(0.2);
  for (const std::string& path : paths) {
    const DriveBudget without = budget_of(without_crack(gear, path), at);
    report.cracks.push_back(
        {.path = path,
         .wind_up = cracked->wind_up.magnitude() - without.wind_up.magnitude(),
         .kinematic_error =
             cracked->kinematic.peak_to_valley() - without.kinematic.peak_to_valley(),
         .hysteresis = cracked->hysteresis.value_or(0.0) - without.hysteresis.value_or(0.0),
         .lost_motion = cracked->lost_motion - without.lost_motion,
         .worst_case = cracked->worst_case().magnitude() - without.worst_case().magnitude()});
  }
  const DriveBudget& present = cracked ? *cracked : intact;
  for (const OrderAtSpeed& of : report.orders)
    if (present.lowest_resonance < of.frequency && of.frequency < present.highest_resonance)
      report.notes.push_back(
          {.code = "accuracy.resonance",
           .text = fmt::format("at this speed the order {} meets the resonance at a torque of the "
                               "turn, where its error may be larger than stated; the resonance "
                               "goes from {} to {} over the turn",
                               shown_number(of.order, 4),
                               shown_quantity(present.lowest_resonance, "Hz", 4),
                               shown_quantity(present.highest_resonance, "Hz", 4)),
           .path = "kinematic_error",
           .equation = "DY-14",
           .severity = Severity::care,
           .next_step = "Choose another speed."});
  const double lost_motion = makers_torques(gear).lost_motion;
  report.contains_lost_motion =
      report.least_torque <= -lost_motion && report.largest_torque >= lost_motion;
  report.bands = bands_of(gear, options, progress.part(0.3, 1.0));
  const std::vector<Note> of_springs =
      coupled ? AssembledDrive(gear).notes() : torsional_stiffness(gear).notes;
  report.notes.insert(report.notes.begin(), of_springs.begin(), of_springs.end());
  note_budget(gear, report);
  report.equations = {"DY-7",  "DY-9",  "DY-10", "DY-12", "DY-14",
                      "DY-15", "DY-16", "TC-17", "TC-18"};
  return report;
}

}  // namespace strainwave
