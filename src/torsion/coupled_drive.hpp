// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "columns.hpp"
#include "coupled_geometry.hpp"
#include "elastic_rings.hpp"

// The coupled drive as a contact problem of elastic rings between balls and flanks that may touch.
//
// The unknowns are the forces of the 20 to 60 contacts that touch, instead of all coefficients of
// the rings.  This gives a small dense system.

namespace strainwave {

/// The linear system of the contacts that touch in some state, factored.
struct ContactSystem {
  std::vector<int> contact;  // those that touch
  Eigen::VectorXd root;      // root of their stiffness
  Eigen::VectorXd border;    // root times the closing per unit of c_0
  Eigen::VectorXd turned;    // force over root per unit of c_0
  double resistance = 0.0;   // of all contacts against c_0
  SmallCholesky factor;
};

/// A state of equilibrium.
struct Equilibrium {
  double torque = 0.0;
  double rotation = 0.0;    // c_0 [m]
  Eigen::VectorXd force;    // forces of all contacts
  Eigen::VectorXd elastic;  // part of the closings due to the rings
  Eigen::VectorXd closing;  // closings u of all contacts
  double residual = 0.0;
  int iterations = 0;
  bool converged = false;
  // The system of the contacts in this state, if it was needed there; it serves the next load.
  std::shared_ptr<const ContactSystem> system = nullptr;
};

class CoupledDrive {
 public:
  /// The sound drive, not yet on its cam.
  CoupledDrive(const GearSet& gear, const CoupledGeometry& geometry, const CoupledOptions& options);
  /// The same drive with cracks, not yet on its cam.
  [[nodiscard]] CoupledDrive cracked(const ContactCracks& cracks) const;
  /// The same drive with deviations of its parts in place of those it has, not yet on its cam.
  [[nodiscard]] CoupledDrive deviating(const Deviations& deviations) const;

  /// Finds the cam amplitude that lifts the lobes to w_0.  Returns false if it is not found.
  [[nodiscard]] bool assemble();
  /// Assembles on a cam of given amplitude, which is that of the sound drive.
  /// @param near  a similar drive on this cam, from which the search begins; null: none
  [[nodiscard]] bool assemble_on(double cam_amplitude, const Equilibrium* near = nullptr);
  [[nodiscard]] const Equilibrium& assembled() const { return assembled_; }
  [[nodiscard]] double cam_amplitude() const { return amplitude_; }

  /// Whether a contact belongs to a lost tooth, which holds nothing.
  [[nodiscard]] bool is_lost(int contact) const { return multiplier_[contact] == 0; }

  /// Whether a flank that is not lost can resist the torque.
  [[nodiscard]] bool can_carry(double torque) const {
    for (int i = g_.balls; i < contacts(); ++i)
      if (rotation_[i] * torque > 0 && !is_lost(i)) return true;
    return torque == 0;
  }

  [[nodiscard]] double largest_flank_force(const Equilibrium& state) const {
    return state.force.tail(contacts() - g_.balls).maxCoeff();
  }

  /// Equilibrium under a torque, from another state on this cam.
  /// @param ahead  closings expected there, which a start with its system may use; empty: those of
  ///               the start
  [[nodiscard]] Equilibrium solve(double torque, const Equilibrium& start,
                                  const Eigen::VectorXd& ahead = {}) const;

  /// Complementary energy W = T c_0/R - V of rings and contacts [J]; dW/dT = c_0/R (MO-27).
  [[nodiscard]] double complementary_energy(const Equilibrium& state) const {
    return -energy(state, state.torque / g_.ring_radius);
  }

  /// Tangent at a state: dQ/dT of all contacts and d c_0/dT.
  struct Tangent {
    Eigen::VectorXd force;  // [1/m]
    double rotation = 0.0;  // [m/(N*m)]
  };
  [[nodiscard]] Tangent tangent(const Equilibrium& state) const;
  /// The system of the contacts in a state.
  [[nodiscard]] std::shared_ptr<const ContactSystem> system_of(const Equilibrium& state) const;
  /// Change of the forces when the free closings move by `moved` and the load by `load`.
  [[nodiscard]] Tangent linear_response(const Equilibrium& state, const Eigen::VectorXd& moved,
                                        double load) const;
  /// Adds the shares of a tangent in the energy of the members of the contact problem; their sum is
  /// d c_0/dT/R.
  void add_shares(const Equilibrium& state, const Tangent& tangent,
                  std::array<double, kCurveMembers>& share) const;

  /// Coefficients of all modes under contact forces, without c_0.
  [[nodiscard]] Eigen::VectorXd coefficients_of(const Eigen::VectorXd& force) const {
    return rings_->coefficients_of(force);
  }
  [[nodiscard]] const ElasticRings& rings() const { return *rings_; }

  [[nodiscard]] int contacts() const { return static_cast<int>(free_.size()); }
  [[nodiscard]] int balls() const { return g_.balls; }
  [[nodiscard]] int tooth_count() const { return tooth_count_; }
  [[nodiscard]] double position_of(int contact) const { return rings_->position_of(contact); }
  [[nodiscard]] const CoupledGeometry& geometry() const { return g_; }
  /// Direction of the force of a flank.
  [[nodiscard]] FlankShares shares_of(int flank) const { return rings_->shares_of(flank); }
  /// +1 for a drive flank, -1 for a coast flank.
  [[nodiscard]] int side_of(int flank) const { return flank < g_.balls + tooth_count_ ? +1 : -1; }
  [[nodiscard]] int ball_nearest_to(double position) const {
    return nearest_of(0, g_.balls, position);
  }
  /// The drive flank of the tooth at a position; absent if this tooth is never loaded.
  [[nodiscard]] std::optional<int> drive_flank_at(double position) const;
  /// Stiffness of a pressed contact [N/m]; 0 for an open contact.
  [[nodiscard]] double stiffness_of(const Equilibrium& state, int contact) const {
    return law(contact, state.closing[contact]).stiffness;
  }

 private:
  void place_balls();
  void place_flanks(const std::vector<ToothFlank>& flanks);
  void soften_contacts(const ContactCracks& cracks);
  [[nodiscard]] int nearest_of(int first, int count, double position) const;
  struct Law {
    double force = 0.0;
    double stiffness = 0.0;
    double energy = 0.0;
  };
  [[nodiscard]] Law law(int contact, double closing) const {
    return closing <= 0 ? Law{} : pressed_law(contact, closing);
  }
  [[nodiscard]] Law pressed_law(int contact, double closing) const;
  /// The force of `law` alone.
  [[nodiscard]] double force_at(int contact, double closing) const {
    return closing <= 0 ? 0.0 : pressed_force(contact, closing);
  }
  [[nodiscard]] double pressed_force(int contact, double closing) const;
  /// Closing of an unloaded contact on rigid rings.
  [[nodiscard]] double rigid_closing(int contact, double rotation) const {
    return free_[contact] + amplitude_ * cam_[contact] + rotation * rotation_[contact];
  }
  /// Sets the closings from forces and rotation; the part of the rings is known already or computed
  /// here.
  void close(Equilibrium& state) const;
  /// The same for some contacts; the others are taken as open.
  void close(Equilibrium& state, const std::vector<ContactRun>& of) const;
  /// The contacts that touch in a state, or almost.
  [[nodiscard]] std::vector<ContactRun> near_contacts(const Equilibrium& state) const;
  void close_rigidly(Equilibrium& state) const;
  /// Energy of a state without the energy of the cam [J].
  [[nodiscard]] double energy(const Equilibrium& state, double load) const;
  /// Forces of the contacts that touch as a linear function of the rotation.
  struct TouchingForces {
    const ContactSystem& system;
    Eigen::VectorXd base;  // force over root without rotation

    [[nodiscard]] double rotation(double load) const {
      return (load - system.border.dot(base)) / system.resistance;
    }
    /// Forces of the contacts of the system.
    [[nodiscard]] Eigen::VectorXd touching(double rotation) const {
      return system.root.cwiseProduct(base + rotation * system.turned);
    }
    /// Forces of all contacts.
    [[nodiscard]] Eigen::VectorXd force(double rotation, int contacts) const;
  };
  /// @param right  (contact, root) -> right-hand side of the contact, over root
  template <class Right>
  [[nodiscard]] TouchingForces forces_of(const ContactSystem& system, const Right& right) const;
  /// Change of the forces that touch, and of the rotation.
  [[nodiscard]] Tangent response_of(const TouchingForces& t, double load) const;
  /// Whether the contacts of a system are those that touch at these closings.
  [[nodiscard]] bool same_contacts(const ContactSystem& system,
                                   const Eigen::VectorXd& closing) const;
  /// A state without forces whose closings are not known yet.
  [[nodiscard]] Equilibrium unloaded() const;
  /// The state after a full step of Newton's method with the system of this state or an earlier
  /// one.
  /// @param of  contacts that may touch then
  [[nodiscard]] Equilibrium newton_step(const ContactSystem& system, const Equilibrium& state,
                                        double load, const std::vector<ContactRun>& of) const;
  /// Newton's method on the contacts of one factored system alone: the steps of `newton_step`
  /// without the contacts that do not touch.
  /// @param guess  closings of all contacts from which the steps begin
  /// @return  a state of all contacts; empty if the first step is not near the equilibrium, or if
  ///          a contact of the system opens
  [[nodiscard]] std::optional<Equilibrium> solve_touching(const ContactSystem& system,
                                                          const Equilibrium& start,
                                                          const Eigen::VectorXd& guess,
                                                          double load) const;
  /// Sets the residual of the forces against the laws of their contacts and the load.
  void judge(Equilibrium& state, double load) const;
  /// Moves toward the full step as far as the energy falls; returns the share of the step.
  double move_toward(const Equilibrium& full, Equilibrium& state, double load) const;
  /// Sets an amplitude of the cam and a state from which the assembly begins.
  void guess_assembled();
  /// Rotation of the ring under a load before the first flank touches.
  [[nodiscard]] double free_travel(const Eigen::VectorXd& closing, double load) const;
  /// Moves the assembled ring to the point of its play that is nearest to rotation 0.
  void rest_nearest_to_zero();

  CoupledGeometry g_;
  double tolerance_ = 0.0;
  int max_iterations_ = 0;
  int tooth_count_ = 0;  // teeth that can engage
  std::shared_ptr<const ElasticRings> rings_;
  std::vector<FlankLaw> flanks_;
  Eigen::VectorXd nominal_;     // free_ without deviations of the parts
  Eigen::VectorXd free_;        // closing without forces, c_0 and cam
  Eigen::VectorXd cam_;         // closing per unit of cam amplitude
  Eigen::VectorXd rotation_;    // closing per unit of c_0
  Eigen::VectorXd multiplier_;  // multiplier of the stiffness of a tooth pair
  Eigen::VectorXd own_;         // compliance in series with a contact

  double amplitude_ = 0.0;
  Equilibrium assembled_;
};

}  // namespace strainwave
