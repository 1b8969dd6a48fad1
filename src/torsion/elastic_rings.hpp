// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "ring_model.hpp"

// The elastic side of the contact problem: flexspline, outer ring and circular spline.
//
// The rings have constant sections, so their Fourier modes decouple into blocks of two.  The
// flexibility between any two contacts is a sum over modes.

namespace strainwave {

/// Cosines and sines of the harmonics 0 to N at some positions, one column for each position.
struct Waves {
  Waves(Eigen::Index positions, int harmonics)
      : cosine(harmonics + 1, positions), sine(harmonics + 1, positions) {}
  /// At given positions.
  Waves(const std::vector<double>& positions, int harmonics);
  Eigen::MatrixXd cosine;
  Eigen::MatrixXd sine;
};

/// Cosines and sines of all multiples of half a pitch.  They serve every harmonic of every tooth,
/// because a harmonic of such an angle is such an angle again.
class HalfPitches {
 public:
  /// @param pitches  of the whole turn
  explicit HalfPitches(int pitches);
  /// The harmonics 0 to N at some angles.
  /// @param angle  column -> angle in half pitches, at least 0
  template <class Angle>
  [[nodiscard]] Waves waves(Eigen::Index positions, int harmonics, const Angle& angle) const {
    Waves waves(positions, harmonics);
    const std::size_t turn = cosine_.size();
    for (Eigen::Index i = 0; i < positions; ++i) {
      const std::size_t step = static_cast<std::size_t>(angle(i)) % turn;
      std::size_t at = 0;
      for (int n = 0; n <= harmonics; ++n) {
        waves.cosine(n, i) = cosine_[at];
        waves.sine(n, i) = sine_[at];
        at += step;
        if (at >= turn) at -= turn;
      }
    }
    return waves;
  }

 private:
  std::vector<double> cosine_;
  std::vector<double> sine_;
};

/// Positions of balls and teeth.
struct ContactPlaces {
  std::vector<double> balls;  ///< positions, evenly around the turn
  std::vector<int> teeth;  ///< numbers of the teeth that may touch, tooth j at (j + 1/2) pitches;
                           ///< in order, and the same after a mirror at a lobe
  int pitches = 1;         ///< pitches of the whole turn
  [[nodiscard]] double pitch() const { return 2 * std::numbers::pi / pitches; }
  [[nodiscard]] double position_of(int tooth) const { return (tooth + 0.5) * pitch(); }
  /// Positions of balls, drive flanks and coast flanks.
  [[nodiscard]] std::vector<double> positions() const;
};

/// Contacts or teeth whose numbers follow each other.
struct ContactRun {
  int first = 0;
  int count = 0;
};

class ElasticRings {
 public:
  /// The contacts are the balls, the drive flanks of the teeth, and their coast flanks.
  /// @param shares  of the flanks
  ElasticRings(const GearSet& gear, const CoupledGeometry& geometry, const CoupledOptions& options,
               const ContactPlaces& places, const std::vector<FlankShares>& shares)
      : ElasticRings(gear, geometry, options, places, shares, HalfPitches(places.pitches)) {}

  /// The same rings, softened by cracks.
  /// @throws SolverError  if hinges of one ring overlap so far that the ring has no stiffness left
  [[nodiscard]] ElasticRings softened(const std::vector<RingHinge>& hinges) const;

  [[nodiscard]] int contacts() const { return static_cast<int>(position_.size()); }
  [[nodiscard]] double position_of(int contact) const {
    return position_[static_cast<std::size_t>(contact)];
  }
  /// Closing of a contact under the nominal wave w_0 cos(2 theta) of an inextensional ring.
  [[nodiscard]] double of_nominal_wave(int contact, double amplitude) const;
  /// Shares of a contact that is a flank.
  [[nodiscard]] FlankShares shares_of(int contact) const;
  /// The model of the rings, in its coefficients.
  [[nodiscard]] const RingModel<double>& model() const { return model_; }
  /// The harmonics of the contact forces on the rings.
  [[nodiscard]] BasicForceWaves<double> waves_of(const Eigen::VectorXd& force) const;
  /// Cosines and sines at the teeth.
  [[nodiscard]] const Waves& at_teeth() const { return at_teeth_; }
  /// Mean of w over the lobes per unit of the force of each contact.
  [[nodiscard]] const Eigen::VectorXd& lobe_of_forces() const { return lobe_; }
  /// Distance by which contact i opens under a unit force of contact j, due to the rings [m/N]
  /// (TC-4), (TC-31).
  [[nodiscard]] const Eigen::MatrixXd& flexibility() const { return flexibility_; }
  /// Closings of all contacts under contact forces.
  [[nodiscard]] Eigen::VectorXd closings(const Eigen::VectorXd& force) const {
    return closings(force, {{.first = 0, .count = contacts()}});
  }
  /// Closings of some contacts under contact forces; 0 for the others.
  [[nodiscard]] Eigen::VectorXd closings(const Eigen::VectorXd& force,
                                         const std::vector<ContactRun>& of) const;
  /// Coefficients of all modes under contact forces.
  [[nodiscard]] Eigen::VectorXd coefficients_of(const Eigen::VectorXd& force) const;
  /// Closings of all contacts from coefficients, without (TC-31).
  [[nodiscard]] Eigen::VectorXd closings_of(const Eigen::VectorXd& x) const {
    return displacements_of(x, model_.ball(), shares_);
  }
  /// Shares of all flanks, one row for each direction.
  using Shares = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  /// Displacements of the rings at all contacts from coefficients, in given directions.
  [[nodiscard]] Eigen::VectorXd displacements_of(const Eigen::VectorXd& x,
                                                 const ContactDirection& of_balls,
                                                 const Shares& of_flanks) const;
  /// Mean of w over the lobes under contact forces.
  [[nodiscard]] double lobe(const Eigen::VectorXd& force) const { return lobe_.dot(force); }
  /// Place of a contact that is a flank.
  [[nodiscard]] FlankPlace flank(int contact) const;
  /// Twice the energy of contact forces in the teeth of the circular spline beside the loaded ones
  /// (TC-31).
  [[nodiscard]] double neighbour_energy(const Eigen::VectorXd& force) const;
  /// Adds twice the energies of a set of coefficients to the members.
  void add_shares(const Eigen::VectorXd& x, std::array<double, kCurveMembers>& share) const;

  [[nodiscard]] double radial(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double tangential(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double curvature(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double hoop_strain(const Eigen::VectorXd& x, double theta) const;
  /// Change of curvature of the circular spline from coefficients, positive if it bends more [1/m].
  [[nodiscard]] double spline_curvature(const Eigen::VectorXd& x, double theta) const;
  /// Hoop force of a free circular spline under the forces of the contacts, harmonics 2 to N, as
  /// cosine and sine coefficients from harmonic 0 (TC-39) [N].
  struct HoopForce {
    Eigen::VectorXd cosine;
    Eigen::VectorXd sine;
    [[nodiscard]] double at(double theta) const;
  };
  [[nodiscard]] HoopForce spline_hoop_force(const Eigen::VectorXd& force) const;

 private:
  ElasticRings(const GearSet& gear, const CoupledGeometry& geometry, const CoupledOptions& options,
               const ContactPlaces& places, const std::vector<FlankShares>& shares,
               const HalfPitches& angles);
  /// Closing of one contact due to another as a Fourier series in the angle between them (TC-4).
  struct Kernel {
    Eigen::VectorXd even;
    Eigen::VectorXd odd;
  };
  /// Number of a tooth that may touch.
  [[nodiscard]] int number(int tooth) const { return tooth_[static_cast<std::size_t>(tooth)]; }
  [[nodiscard]] Kernel kernel(const ContactDirection& of, const ContactDirection& by) const;
  void fill_flexibility(const ContactPlaces& places, const HalfPitches& angles);
  void fill_balls(const ContactPlaces& places);
  /// How balls open under forces of all teeth in one direction.
  /// @param kernel  the harmonics, even or odd in the angle between ball and tooth
  [[nodiscard]] Eigen::MatrixXd balls_by_teeth(const Eigen::VectorXd& kernel, bool odd,
                                               const ContactPlaces& places) const;
  void fill_flanks(const ContactPlaces& places, const HalfPitches& angles);
  void fill_lobe();

  RingModel<double> model_;
  int balls_ = 0;
  int teeth_ = 0;
  std::vector<int> tooth_;  // numbers of the teeth
  Shares shares_;           // of drive flanks, coast flanks
  std::optional<ToothNeighbours> neighbours_;
  std::vector<double> position_;  // positions of balls, drive flanks, coast flanks
  Waves at_balls_;
  Waves at_teeth_;
  Eigen::VectorXd lobe_;  // lobe displacement per unit force of each contact
  Eigen::MatrixXd flexibility_;
};

}  // namespace strainwave
