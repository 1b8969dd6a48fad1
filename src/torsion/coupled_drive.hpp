// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <string>
#include <vector>

#include "strainwave/torsion/flank.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

// The coupled drive as a contact problem.
//
// The rings have constant sections, so their Fourier modes decouple into blocks of two and the
// flexibility between any two contacts is a sum over modes.  What is left to solve are the forces
// of the contacts that touch, 20 to 60, instead of all coefficients: a small dense system.

namespace strainwave {

/// The numbers of the model, taken from the file [SI].
struct CoupledGeometry {
  // transmission
  double pitch_radius = 0.0;         // R_p
  double radial_displacement = 0.0;  // w_0
  int teeth = 0;                     // z
  double module = 0.0;               // m
  // rim and outer ring, as one ring
  double ring_radius = 0.0;    // R
  double rim_thickness = 0.0;  // t_r
  double rim_width = 0.0;      // b
  double rim_bending = 0.0;    // EI of the rim
  double outer_bending = 0.0;  // EI of the outer ring
  double extension = 0.0;      // EA
  double outer_thickness = 0.0;
  double outer_width = 0.0;
  ElasticConstants rim_steel;
  ElasticConstants ball_steel;
  // barrel and diaphragm
  double barrel_length = 0.0;
  double barrel_thickness = 0.0;
  double length = 0.0;  // L, from the bottom to the open end
  // bearing
  double ball_stiffness = 0.0;  // K_h, Q = K_h d^1.5
  int balls = 0;
  double clearance = 0.0;
  double cam_flattening = 0.0;  // c_cam
  // mesh
  double flank_angle = 0.0;  // geometric alpha
  double force_angle = 0.0;  // alpha turned by friction
  double gap_factor = 0.0;
  double lobe_gap = 0.0;
  FlankLaw flank;
  // circular spline; support 0: rigid
  double spline_radius = 0.0;   // R_c
  double spline_bending = 0.0;  // E I_c
  double support = 0.0;         // s_h
};

/// What a crack changes inside the contact problem.
struct RingHinge {
  enum class Ring { rim, outer, spline } ring = Ring::rim;
  double position = 0.0;   // theta_c
  double length = 0.0;     // l, over which the crack softens the ring [m]
  double softening = 0.0;  // alpha, bending stiffness lost times length (TC-22) [N*m^3]
};
struct SoftTooth {
  double position = 0.0;
  double stiffness_loss = 0.0;
};
struct SoftBall {
  double position = 0.0;
  double compliance = 0.0;  // in series with the contact [m/N]
};
struct ContactCracks {
  std::vector<RingHinge> hinges;
  std::vector<SoftTooth> teeth;
  std::vector<SoftBall> balls;
};

[[nodiscard]] CoupledGeometry coupled_geometry(const GearSet& gear, const CoupledOptions& options);
/// Force of the ball nearest to a position, in the sound drive [N].
using BallForce = std::function<double(double position)>;
[[nodiscard]] ContactCracks contact_cracks(const GearSet& gear, const CoupledGeometry& geometry,
                                           const BallForce& ball_force, std::vector<Note>& notes);

/// A state of equilibrium.
struct Equilibrium {
  double torque = 0.0;
  double rotation = 0.0;    // c_0 [m]
  Eigen::VectorXd force;    // of all contacts
  Eigen::VectorXd closing;  // u of all contacts
  double residual = 0.0;
  int iterations = 0;
  bool converged = false;
};

class CoupledDrive {
 public:
  CoupledDrive(const GearSet& gear, const CoupledGeometry& geometry, const ContactCracks& cracks,
               const CoupledOptions& options);

  /// Assembles: the cam amplitude that lifts the lobes to w_0.  False if it cannot be found.
  [[nodiscard]] bool assemble();
  /// Assembles on a cam of given amplitude, which does not know of cracks.
  [[nodiscard]] bool assemble_on(double cam_amplitude);
  [[nodiscard]] const Equilibrium& assembled() const { return assembled_; }
  [[nodiscard]] double cam_amplitude() const { return amplitude_; }

  [[nodiscard]] double largest_flank_force(const Equilibrium& state) const {
    return state.force.tail(contacts() - g_.balls).maxCoeff();
  }

  [[nodiscard]] Equilibrium solve(double torque, const Equilibrium& start);

  /// Tangent at a state: dQ/dT of all contacts, and d c_0/dT.
  struct Tangent {
    Eigen::VectorXd force;  // [1/m]
    double rotation = 0.0;  // [m/(N*m)]
  };
  [[nodiscard]] Tangent tangent(const Equilibrium& state);
  /// Change of the forces when the free closings move by `moved` and the load by `load`.
  [[nodiscard]] Tangent linear_response(const Equilibrium& state, const Eigen::VectorXd& moved,
                                        double load);
  /// Shares of a tangent in the energy of members of the contact problem, d c_0/dT/R in all.
  void add_shares(const Equilibrium& state, const Tangent& tangent,
                  std::array<double, kCurveMembers>& share) const;

  /// Coefficients of all modes that contact forces make, without c_0.
  [[nodiscard]] Eigen::VectorXd coefficients_of(const Eigen::VectorXd& force) const;
  [[nodiscard]] double radial(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double tangential(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double curvature(const Eigen::VectorXd& x, double theta) const;
  [[nodiscard]] double hoop_strain(const Eigen::VectorXd& x, double theta) const;

  [[nodiscard]] int contacts() const { return static_cast<int>(free_.size()); }
  [[nodiscard]] int balls() const { return g_.balls; }
  [[nodiscard]] int tooth_count() const { return tooth_count_; }
  [[nodiscard]] double position_of(int contact) const {
    return theta_[static_cast<std::size_t>(contact)];
  }
  [[nodiscard]] const CoupledGeometry& geometry() const { return g_; }

 private:
  struct Mode {  // stiffness per unit of amplitude squared, of both phases
    double rim_bending = 0.0;
    double outer_bending = 0.0;
    double barrel = 0.0;
    double diaphragm = 0.0;
    double extension = 0.0;  // of a + n d
    double lateral = 0.0;    // n = 1
    double spline = 0.0;
  };
  [[nodiscard]] int at(int n) const { return 4 * n - 3; }  // a_n, b_n, c_n, d_n of the ring
  [[nodiscard]] int spline_at(int n) const { return 1 + 4 * N_ + 2 * (n - 2); }  // a_n, b_n
  void make_modes(const GearSet& gear, const CoupledOptions& options);
  void make_contacts();
  void soften(const std::vector<RingHinge>& hinges);
  void soften_contacts(const ContactCracks& cracks);
  void fill_row(int contact, double theta, double radial, double tangential, double slope,
                double spline_radial, double spline_tangential, double spline_slope);
  void apply_compliance(const Eigen::VectorXd& load, Eigen::Ref<Eigen::VectorXd> out) const;
  [[nodiscard]] double flexibility(int i, int j);
  /// Moves the assembled ring to the point of its play that is nearest to rotation 0.
  void rest_nearest_to_zero();
  struct Law {
    double force = 0.0;
    double stiffness = 0.0;
    double energy = 0.0;
  };
  [[nodiscard]] Law law(int contact, double closing) const;
  [[nodiscard]] Eigen::VectorXd closing(const Eigen::VectorXd& force, double rotation) const;
  /// How far the ring turns under a load before the first flank touches.
  [[nodiscard]] double free_travel(const Eigen::VectorXd& closing, double load) const;
  [[nodiscard]] int coefficients() const {
    return 1 + 4 * N_ + (g_.support > 0 ? 2 * (N_ - 1) : 0);
  }

  CoupledGeometry g_;
  int N_ = 0;
  double tolerance_ = 0.0;
  int max_iterations_ = 0;
  std::vector<Mode> modes_;  // 0 to N
  int tooth_count_ = 0;      // teeth within 45 degrees of a lobe

  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Rows row_;                  // how a contact sees the coefficients
  Rows compliant_row_;        // the coefficients that its unit force makes
  Eigen::VectorXd free_;      // closing without forces, c_0 and cam
  Eigen::VectorXd cam_;       // closing per unit of cam amplitude
  Eigen::VectorXd rotation_;  // closing per unit of c_0
  std::vector<double> theta_;
  Eigen::VectorXd multiplier_;  // of the stiffness of a tooth pair
  Eigen::VectorXd own_;         // compliance in series with a contact
  Rows flexibility_;            // NaN where not computed yet
  Eigen::VectorXd lobe_;        // mean of w over the lobes, as a row
  struct Softening {
    RingHinge::Ring ring = RingHinge::Ring::rim;
    double softening = 0.0;     // alpha
    Eigen::VectorXd curvature;  // mean over the length, as a row
    Eigen::VectorXd response;   // coefficients that a unit of its conjugate makes
    double factor = 0.0;        // alpha/(1 - alpha curvature.response)
  };
  std::vector<Softening> softenings_;

  double amplitude_ = 0.0;
  Equilibrium assembled_;
};

}  // namespace strainwave
