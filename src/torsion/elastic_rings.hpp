// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <numbers>
#include <vector>

#include "coupled_geometry.hpp"

// The elastic side of the contact problem: flexspline, outer ring and circular spline.
//
// The rings have constant sections, so their Fourier modes decouple into blocks of two.  The
// flexibility between any two contacts is a sum over modes.

namespace strainwave {

/// Closing of a contact per unit of displacement of the rings at its position.
struct ContactDirection {
  double radial = 0.0;
  double tangential = 0.0;
  double slope = 0.0;  ///< slope w' of the wall
  double spline_radial = 0.0;
  double spline_tangential = 0.0;
  double spline_slope = 0.0;

  /// Closing per unit of the n-th amplitude by tilt and shift of the circular spline, whose ring
  /// does not stretch.
  [[nodiscard]] double spline_turn(int n) const { return n * spline_slope + spline_tangential / n; }
  /// The direction of the other flank of a tooth.
  [[nodiscard]] ContactDirection mirrored() const {
    return {radial, -tangential, -slope, spline_radial, -spline_tangential, -spline_slope};
  }
};

/// Cosines and sines of the harmonics 0 to N at given positions, one row for each position.
struct Waves {
  Waves(const std::vector<double>& positions, int harmonics);
  Eigen::MatrixXd cosine;
  Eigen::MatrixXd sine;
};

/// Positions of balls and teeth.
struct ContactPlaces {
  std::vector<double> balls;  ///< positions
  std::vector<int> teeth;     ///< numbers of the teeth that may touch, tooth j at (j + 1/2) pitches
  int pitches = 1;            ///< pitches of the whole turn
  [[nodiscard]] double pitch() const { return 2 * std::numbers::pi / pitches; }
  /// Positions of balls, drive flanks and coast flanks.
  [[nodiscard]] std::vector<double> positions() const;
};

class ElasticRings {
 public:
  /// The contacts are the balls, the drive flanks of the teeth, and their coast flanks, which are
  /// mirror images of the drive flanks.
  ElasticRings(const GearSet& gear, const CoupledGeometry& geometry, const CoupledOptions& options,
               const ContactPlaces& places, const ContactDirection& ball,
               const ContactDirection& drive_flank);

  /// The same rings, softened by cracks.
  /// @throws SolverError  if hinges of one ring overlap so far that the ring has no stiffness left
  [[nodiscard]] ElasticRings softened(const std::vector<RingHinge>& hinges) const;

  [[nodiscard]] int contacts() const { return static_cast<int>(position_.size()); }
  [[nodiscard]] double position_of(int contact) const {
    return position_[static_cast<std::size_t>(contact)];
  }
  /// Closing of a contact under the nominal wave w_0 cos(2 theta) of an inextensional ring.
  [[nodiscard]] double of_nominal_wave(int contact, double amplitude) const;
  /// Closing of contact i under a unit force of contact j, due to the rings [m/N] (TC-4).
  [[nodiscard]] const Eigen::MatrixXd& flexibility() const { return flexibility_; }
  /// Closings of all contacts under contact forces.
  [[nodiscard]] Eigen::VectorXd closings(const Eigen::VectorXd& force) const;
  /// Coefficients of all modes under contact forces.
  [[nodiscard]] Eigen::VectorXd coefficients_of(const Eigen::VectorXd& force) const;
  /// Closings of all contacts from coefficients.
  [[nodiscard]] Eigen::VectorXd closings_of(const Eigen::VectorXd& x) const;
  /// Mean of w over the lobes under contact forces.
  [[nodiscard]] double lobe(const Eigen::VectorXd& force) const { return lobe_.dot(force); }
  /// Adds twice the energies of a set of coefficients to the members.
  void add_shares(const Eigen::VectorXd& x, std::array<double, kCurveMembers>& share) const;

  [[nodiscard]] double radial(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double tangential(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double curvature(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double hoop_strain(const Eigen::VectorXd& x, double theta) const;

 private:
  struct Mode {  // stiffness per unit of amplitude squared, of both phases
    double rim_bending = 0.0;
    double outer_bending = 0.0;
    double barrel = 0.0;
    double diaphragm = 0.0;
    double extension = 0.0;  // stiffness of a + n d
    double lateral = 0.0;    // n = 1
    double spline = 0.0;

    struct Inverse {  // (TC-4): inverse of [[bend + ke, n ke], [n ke, n^2 ke]]
      double ww = 0.0;
      double wv = 0.0;
      double vv = 0.0;
    };
    Inverse inverse;
    [[nodiscard]] Inverse inverted(int n) const;
  };
  struct Softening {
    RingHinge::Ring ring = RingHinge::Ring::rim;
    double softening = 0.0;     // alpha
    Eigen::VectorXd curvature;  // mean curvature over the length, as a row
    Eigen::VectorXd response;   // coefficients under a unit of its conjugate
    double factor = 0.0;        // alpha/(1 - alpha curvature.response)
  };

  /// Closing of one contact due to another as a Fourier series in the angle between them (TC-4).
  struct Kernel {
    Eigen::VectorXd even;
    Eigen::VectorXd odd;
  };
  [[nodiscard]] int at(int n) const { return 4 * n - 3; }  // a_n, b_n, c_n, d_n of the ring
  [[nodiscard]] int spline_at(int n) const { return 1 + 4 * N_ + 2 * (n - 2); }  // a_n, b_n
  [[nodiscard]] int coefficients() const { return 1 + 4 * N_ + (has_spline_ ? 2 * (N_ - 1) : 0); }
  void make_modes(const GearSet& gear, const CoupledGeometry& geometry,
                  const CoupledOptions& options);
  [[nodiscard]] Kernel kernel(const ContactDirection& of, const ContactDirection& by) const;
  void fill_flexibility(const ContactPlaces& places);
  void fill_lobe();
  /// A group of contacts of one direction, with the waves at their positions.
  struct Group {
    int first = 0;
    const Waves& waves;
    ContactDirection direction;
  };
  [[nodiscard]] std::array<Group, 3> groups() const;
  /// Generalised forces of contact forces, by the transposed operation with opposite sign.
  [[nodiscard]] Eigen::VectorXd load_of(const Eigen::VectorXd& force) const;
  /// Coefficients under generalised forces (TC-4).
  [[nodiscard]] Eigen::VectorXd response_to(const Eigen::VectorXd& load) const;

  int N_ = 0;
  bool has_spline_ = false;
  double ring_radius_ = 0.0;
  double spline_radius_ = 0.0;
  std::vector<Mode> modes_;  // 0 to N
  int balls_ = 0;
  int teeth_ = 0;
  ContactDirection ball_;
  ContactDirection drive_flank_;
  std::vector<double> position_;  // positions of balls, drive flanks, coast flanks
  Waves at_balls_;
  Waves at_teeth_;
  Eigen::VectorXd lobe_;  // lobe displacement per unit force of each contact
  std::vector<Softening> softenings_;
  Eigen::MatrixXd flexibility_;
};

}  // namespace strainwave
