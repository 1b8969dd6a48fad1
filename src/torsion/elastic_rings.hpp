// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <atomic>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "coupled_geometry.hpp"

// The elastic side of the contact problem: flexspline, outer ring and circular spline.
//
// The rings have constant sections, so their Fourier modes decouple into blocks of two and the
// flexibility between any two contacts is a sum over modes.

namespace strainwave {

/// How a contact sees the rings: closing per unit of displacement at its position.
struct ContactDirection {
  double radial = 0.0;
  double tangential = 0.0;
  double slope = 0.0;  ///< of the wall, w'
  double spline_radial = 0.0;
  double spline_tangential = 0.0;
  double spline_slope = 0.0;
};

/// Cosines and sines of all harmonics at the positions of the contacts.
class Waves {
 public:
  Waves(std::vector<double> positions, int harmonics);

  [[nodiscard]] bool are_of(const std::vector<double>& positions, int harmonics) const {
    return positions == positions_ && harmonics == cosine_.cols();
  }
  [[nodiscard]] double cosine(int position, int n) const { return cosine_(position, n - 1); }
  [[nodiscard]] double sine(int position, int n) const { return sine_(position, n - 1); }

 private:
  using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<double> positions_;
  Table cosine_;
  Table sine_;
};

/// A symmetric square of numbers that are found when first asked for, by any thread; a copy knows
/// none.
class Memo {
 public:
  explicit Memo(int size)
      : size_(size), entries_(std::make_unique<std::atomic<double>[]>(count())) {
    for (std::size_t i = 0; i < count(); ++i)
      entries_[i].store(std::numeric_limits<double>::quiet_NaN(), std::memory_order_relaxed);
  }
  Memo(const Memo& other) : Memo(other.size_) {}
  Memo(Memo&&) noexcept = default;
  Memo& operator=(Memo other) noexcept {
    std::swap(size_, other.size_);
    std::swap(entries_, other.entries_);
    return *this;
  }
  ~Memo() = default;

  /// The number at row i, column j <= i.  Relaxed order is enough: all threads find the same
  /// number.
  template <class Find>
  [[nodiscard]] double at(int i, int j, const Find& find) const {
    std::atomic<double>& entry = entries_[triangle(i) + static_cast<std::size_t>(j)];
    double value = entry.load(std::memory_order_relaxed);
    if (std::isnan(value)) {
      value = find();
      entry.store(value, std::memory_order_relaxed);
    }
    return value;
  }

 private:
  /// Entries of the rows before row i.
  [[nodiscard]] static std::size_t triangle(int i) {
    return static_cast<std::size_t>(i) * (static_cast<std::size_t>(i) + 1) / 2;
  }
  [[nodiscard]] std::size_t count() const { return triangle(size_); }

  int size_ = 0;
  std::unique_ptr<std::atomic<double>[]> entries_;
};

class ElasticRings {
 public:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// With room for contacts, which `set_contacts` fills.
  ElasticRings(const GearSet& gear, const CoupledGeometry& geometry, const CoupledOptions& options,
               int contacts);

  /// Contacts at one position of the waves, each with the number of its row.
  void set_contacts(const Waves& waves, int position,
                    std::initializer_list<std::pair<int, ContactDirection>> contacts);
  /// The same rings, softened by cracks.
  [[nodiscard]] ElasticRings softened(const std::vector<RingHinge>& hinges) const;

  [[nodiscard]] int contacts() const { return static_cast<int>(row_.rows()); }
  /// How the contacts see the coefficients.
  [[nodiscard]] const Rows& rows() const { return row_; }
  /// What a contact sees of the nominal wave w_0 cos(2 theta) of an inextensional ring.
  [[nodiscard]] double of_nominal_wave(int contact, double amplitude) const;
  /// Closing of contact i under a unit force of contact j <= i, by the rings [m/N] (TC-4).
  [[nodiscard]] double flexibility(int i, int j) const {
    return flexibility_.at(i, j, [&] { return row_.row(i).dot(compliant_row_.row(j)); });
  }
  /// Coefficients that the forces make one after the other, those that are 0 left out.
  [[nodiscard]] Eigen::VectorXd sum_of(const Eigen::VectorXd& force) const;
  /// Coefficients that the forces make, as one product.
  [[nodiscard]] Eigen::VectorXd product_of(const Eigen::VectorXd& force) const;
  /// Mean of w over the lobes.
  [[nodiscard]] double lobe(const Eigen::VectorXd& x) const { return lobe_.dot(x); }
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
    double extension = 0.0;  // of a + n d
    double lateral = 0.0;    // n = 1
    double spline = 0.0;

    struct Inverse {  // (TC-4): of [[bend + ke, n ke], [n ke, n^2 ke]]
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
    Eigen::VectorXd curvature;  // mean over the length, as a row
    Eigen::VectorXd response;   // coefficients that a unit of its conjugate makes
    double factor = 0.0;        // alpha/(1 - alpha curvature.response)
  };
  using Row = Eigen::Map<const Eigen::VectorXd>;
  using MutableRow = Eigen::Map<Eigen::VectorXd>;

  [[nodiscard]] int at(int n) const { return 4 * n - 3; }  // a_n, b_n, c_n, d_n of the ring
  [[nodiscard]] int spline_at(int n) const { return 1 + 4 * N_ + 2 * (n - 2); }  // a_n, b_n
  [[nodiscard]] int coefficients() const { return 1 + 4 * N_ + (has_spline_ ? 2 * (N_ - 1) : 0); }
  void make_modes(const GearSet& gear, const CoupledGeometry& geometry,
                  const CoupledOptions& options);
  /// Coefficients that generalised forces make (TC-4), without the softenings.
  void apply_compliance(const Row& load, MutableRow out) const;
  void add_softening(const Softening& soft, const Row& load, MutableRow out) const;

  int N_ = 0;
  bool has_spline_ = false;
  double ring_radius_ = 0.0;
  double spline_radius_ = 0.0;
  std::vector<Mode> modes_;  // 0 to N
  Rows row_;
  Rows compliant_row_;  // the coefficients that the unit force of a contact makes
  Eigen::VectorXd lobe_;
  std::vector<Softening> softenings_;
  Memo flexibility_;
};

}  // namespace strainwave
