// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/frequency_response.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "free_chain.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Frequencies in a decade at which extrema are looked for [-].
constexpr double kSearchedPerDecade = 200;

/// The product without the check for numbers that are not finite, which costs more than the
/// product.
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Complex reciprocal(const Complex& a) {
  const double square = a.real() * a.real() + a.imag() * a.imag();
  return {a.real() / square, -a.imag() / square};
}

bool finite(const Complex& a) { return std::isfinite(a.real()) && std::isfinite(a.imag()); }

/// Size of a number, for the choice of a pivot.
double size_of(const Complex& a) { return std::abs(a.real()) + std::abs(a.imag()); }

/// Matrix, factors and solutions for a number of free inertias that the compiler knows.  Eigen's
/// matrices of a fixed size take twice as long, because their products check for numbers that are
/// not finite.
template <std::size_t N>
struct SmallSystem {
  std::array<std::array<Complex, N>, N> factor{};
  std::array<std::size_t, N> row{};  ///< row of the matrix at each place

  /// Factors the matrix by elimination with exchange of rows.
  void decompose() {
    for (std::size_t i = 0; i < N; ++i) row[i] = i;
    for (std::size_t k = 0; k < N; ++k) {
      std::size_t best = k;
      for (std::size_t i = k + 1; i < N; ++i)
        if (size_of(factor[i][k]) > size_of(factor[best][k])) best = i;
      if (best != k) {
        std::swap(factor[k], factor[best]);
        std::swap(row[k], row[best]);
      }
      factor[k][k] = reciprocal(factor[k][k]);
      for (std::size_t i = k + 1; i < N; ++i) {
        factor[i][k] = times(factor[i][k], factor[k][k]);
        for (std::size_t j = k + 1; j < N; ++j) factor[i][j] -= times(factor[i][k], factor[k][j]);
      }
    }
  }

  /// The solution for a torque of 1 at one place.
  [[nodiscard]] std::array<Complex, N> answer(std::size_t loaded) const {
    std::array<Complex, N> x{};
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = row[i] == loaded ? 1.0 : 0.0;
      for (std::size_t j = 0; j < i; ++j) x[i] -= times(factor[i][j], x[j]);
    }
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t j = i + 1; j < N; ++j) x[i] -= times(factor[i][j], x[j]);
      x[i] = times(x[i], factor[i][i]);
    }
    return x;
  }
};

/// Inertias of the longest chain that has a `SmallSystem` [-].
constexpr std::size_t kMostSmall = 5;

/// A path in the free inertias of a chain.
struct FreePath {
  std::size_t asked = 0;       ///< place in `ResponseSolver::asked_`
  Eigen::VectorXd stiff = {};  ///< torque per excitation, its part without the frequency
  Eigen::VectorXd slow = {};   ///< its part that is multiplied by i omega
  bool held = false;           ///< the asked inertia does not turn
};

/// The responses of some paths at any frequency.
class ResponseSolver {
 public:
  ResponseSolver(const TorsionalChain& chain, std::span<const ChainPath> paths,
                 std::span<const std::size_t> held)
      : chain_(free_chain(chain, held)) {
    const auto n = static_cast<Eigen::Index>(chain_.inertia.size());
    for (const ChainPath& path : paths) {
      FreePath& made = paths_.emplace_back();
      made.stiff = Eigen::VectorXd::Zero(n);
      made.slow = Eigen::VectorXd::Zero(n);
      if (path.by == ShakenBy::torque) {
        const auto place = place_of(path.at);
        if (!place) throw InputError("loaded", "must be an inertia of the chain that can turn");
        made.stiff(static_cast<Eigen::Index>(*place)) = 1.0;
      } else {
        if (path.at >= chain.springs.size())
          throw InputError("spring", "must be a spring of the chain");
        // (DY-7): the torque of the spring by the error alone acts against g.
        const Eigen::VectorXd g = chain_.twist.row(static_cast<Eigen::Index>(path.at));
        made.stiff = -g / chain.springs[path.at].compliance;
        made.slow = -g * chain.springs[path.at].damping;
      }
      if (path.inertia >= chain.inertias.size())
        throw InputError("inertia", "must be an inertia of the chain");
      const auto place = place_of(path.inertia);
      made.held = !place;
      if (!place) continue;
      const auto known = std::ranges::find(asked_, *place);
      made.asked = static_cast<std::size_t>(known - asked_.begin());
      if (known == asked_.end()) asked_.push_back(*place);
    }
    answers_.assign(asked_.size(), Eigen::VectorXcd::Zero(n));
  }

  [[nodiscard]] bool damped() const { return !chain_.damping.isZero(0.0); }

  /// Writes the response of each path; not finite at a resonance without damping.
  void solve(double frequency, std::span<Complex> to) {
    require(frequency > 0 && std::isfinite(frequency), "frequency", frequency, "Hz", "> 0");
    const double omega = 2 * pi * frequency;
    switch (chain_.inertia.size()) {
      case 1:
        return solve_small<1>(omega, to);
      case 2:
        return solve_small<2>(omega, to);
      case 3:
        return solve_small<3>(omega, to);
      case 4:
        return solve_small<4>(omega, to);
      case kMostSmall:
        return solve_small<kMostSmall>(omega, to);
      default:
        return solve_large(omega, to);
    }
  }

 private:
  [[nodiscard]] std::optional<std::size_t> place_of(std::size_t inertia) const {
    for (std::size_t j = 0; j < chain_.inertia.size(); ++j)
      if (chain_.inertia[j] == inertia) return j;
    return std::nullopt;
  }

  /// (DY-12): the matrix is symmetric, so the answer at the asked inertia is the product of the
  /// excitation and the answers to a torque on this inertia.
  void combine(double omega, std::span<Complex> to) const {
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      const FreePath& path = paths_[p];
      Complex sum = 0.0;
      for (Eigen::Index j = 0; j < path.stiff.size() && !path.held; ++j)
        sum += times(Complex(path.stiff(j), omega * path.slow(j)), answers_[path.asked](j));
      to[p] = sum;
    }
  }

  template <std::size_t N>
  void solve_small(double omega, std::span<Complex> to) {
    SmallSystem<N> system;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) {
        const auto row = static_cast<Eigen::Index>(i);
        const auto column = static_cast<Eigen::Index>(j);
        system.factor[i][j] = {
            chain_.stiffness(row, column) - (i == j ? omega * omega * chain_.mass(row) : 0.0),
            omega * chain_.damping(row, column)};  // (DY-6)
      }
    system.decompose();
    for (std::size_t a = 0; a < asked_.size(); ++a) {
      const std::array<Complex, N> x = system.answer(asked_[a]);
      for (std::size_t j = 0; j < N; ++j) answers_[a](static_cast<Eigen::Index>(j)) = x[j];
    }
    combine(omega, to);
  }

  void solve_large(double omega, std::span<Complex> to) {
    Eigen::MatrixXcd dynamic =
        chain_.stiffness.cast<Complex>() + Complex(0, omega) * chain_.damping;  // (DY-6)
    dynamic.diagonal() -= omega * omega * chain_.mass;
    const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(dynamic);
    for (std::size_t a = 0; a < asked_.size(); ++a)
      answers_[a] = factors.solve(
          Eigen::VectorXcd::Unit(dynamic.rows(), static_cast<Eigen::Index>(asked_[a])));
    combine(omega, to);
  }

  FreeChain chain_;
  std::vector<FreePath> paths_;
  std::vector<std::size_t> asked_;         ///< places of the asked inertias, each once
  std::vector<Eigen::VectorXcd> answers_;  ///< to a torque on each asked inertia
};

void require_range(double from, double to) {
  require(from > 0 && std::isfinite(from), "from", from, "Hz", "> 0");
  require(to > from && std::isfinite(to), "to", to, "Hz", "above the first frequency");
}

/// Frequencies at which extrema are looked for, rising.
std::vector<double> searched_frequencies(const TorsionalChain& chain, double from, double to,
                                         std::span<const std::size_t> held) {
  require_range(from, to);
  const double decades = std::log10(to / from);
  std::vector<double> searched = logarithmic_frequencies(
      from, to, static_cast<std::size_t>(std::ceil(decades * kSearchedPerDecade)) + 3);
  for (const ChainMode& mode : chain_modes(chain, held))
    if (mode.frequency > from && mode.frequency < to)
      // Beside the frequency, because the response is infinite there without damping.
      for (const double beside : {1 - 1e-6, 1 + 1e-6}) searched.push_back(mode.frequency * beside);
  std::ranges::sort(searched);
  return searched;
}

}  // namespace

std::vector<double> logarithmic_frequencies(double from, double to, std::size_t points) {
  require_range(from, to);
  require(points >= 2, "points", static_cast<double>(points), "1", ">= 2");
  std::vector<double> frequencies(points);
  const double step = std::log(to / from) / static_cast<double>(points - 1);
  for (std::size_t n = 0; n < points; ++n)
    frequencies[n] = from * std::exp(step * static_cast<double>(n));
  frequencies.back() = to;
  return frequencies;
}

bool has_damping(const TorsionalChain& chain, std::span<const std::size_t> held) {
  return !free_chain(chain, held).damping.isZero(0.0);
}

std::vector<std::vector<Complex>> frequency_responses(const TorsionalChain& chain,
                                                      std::span<const ChainPath> paths,
                                                      std::span<const double> frequencies,
                                                      std::span<const std::size_t> held) {
  ResponseSolver solver(chain, paths, held);
  std::vector<std::vector<Complex>> responses(paths.size(),
                                              std::vector<Complex>(frequencies.size()));
  std::vector<Complex> at(paths.size());
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    solver.solve(frequencies[n], at);
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (!finite(at[p])) refuse_infinite_response();
      responses[p][n] = at[p];
    }
  }
  return responses;
}

std::vector<ResponseExtremum> response_extrema(const TorsionalChain& chain, const ChainPath& path,
                                               double from, double to,
                                               std::span<const std::size_t> held) {
  const std::array paths = {path};
  ResponseSolver solver(chain, paths, held);
  const auto response = [&](double frequency) {
    std::array<Complex, 1> found{};
    solver.solve(frequency, found);
    return found.front();
  };
  const auto amplitude = [&](double frequency) {
    const Complex at = response(frequency);
    return finite(at) ? std::abs(at) : std::numeric_limits<double>::infinity();
  };
  const std::vector<double> searched = searched_frequencies(chain, from, to, held);
  std::vector<double> size(searched.size());
  std::ranges::transform(searched, size.begin(), amplitude);

  // A zero of the response lifts the phase, and a least amplitude between two resonances does not.
  const auto phase_rises = [&](double frequency) {
    const double step = 1e-6 * frequency;
    return std::arg(response(frequency + step) / response(frequency - step)) > 0;
  };

  struct Found {
    ResponseExtremum extremum;
    std::size_t place = 0;  ///< in `searched`
    bool shown = true;      ///< false: a plain least amplitude between two resonances
  };
  std::vector<Found> found;
  for (std::size_t n = 1; n + 1 < searched.size(); ++n) {
    const bool peak = size[n] > size[n - 1] && size[n] >= size[n + 1];
    const bool valley = size[n] < size[n - 1] && size[n] <= size[n + 1];
    if (!peak && !valley) continue;
    const double low = searched[n - 1];
    const double high = searched[n + 1];
    ResponseExtremum extremum{.kind = peak ? ExtremumKind::resonance : ExtremumKind::antiresonance};
    bool shown = true;
    const auto real = [&](double frequency) {
      const Complex at = response(frequency);
      return !peak ? at.real() : finite(at) ? 1 / at.real() : 0.0;
    };
    // Without damping the response is real: it is infinite or 0 where it changes its sign.
    if (!solver.damped() && real(low) * real(high) < 0) {
      extremum.frequency = bracketed_root(real, low, high);
      extremum.damping_ratio = 0.0;
      if (!peak) extremum.amplitude = 0.0;
    } else {
      const double sign = peak ? -1.0 : 1.0;
      const auto [at, value] = boost::math::tools::brent_find_minima(
          [&](double frequency) { return sign * amplitude(frequency); }, low, high, 52);
      extremum.frequency = at;
      extremum.amplitude = sign * value;
      // Dampers on the inertia whose angle is asked do not act where this inertia rests.
      // There the amplitude is that of the error of the place, which is about 1e-8 of the
      // frequency.
      constexpr double kPlace = 1e-7;
      const double slope =
          std::min(size[n - 1] / (at - low), size[n + 1] / (high - at));  // of the sides of a V
      if (!peak && *extremum.amplitude <= kPlace * at * slope) {
        extremum.amplitude = 0.0;
        extremum.damping_ratio = 0.0;
      } else if (!peak) {
        shown = phase_rises(at);
      }
    }
    found.push_back({extremum, n, shown});
  }
  // (DY-13): a change by sqrt(2) on both sides, before the next extremum.
  for (std::size_t e = 0; e < found.size(); ++e) {
    ResponseExtremum& extremum = found[e].extremum;
    if (extremum.damping_ratio || !extremum.amplitude || *extremum.amplitude == 0) continue;
    const bool peak = extremum.kind == ExtremumKind::resonance;
    const double level =
        *extremum.amplitude * (peak ? 1 / std::numbers::sqrt2 : std::numbers::sqrt2);
    const auto beyond = [&](double frequency) {
      return peak ? level - amplitude(frequency) : amplitude(frequency) - level;
    };
    const std::size_t first = e == 0 ? 0 : found[e - 1].place;
    const std::size_t last = e + 1 == found.size() ? searched.size() - 1 : found[e + 1].place;
    std::optional<double> low;
    for (std::size_t n = found[e].place; n > first && !low; --n)
      if (beyond(searched[n - 1]) >= 0)
        low = bracketed_root(beyond, searched[n - 1], extremum.frequency);
    std::optional<double> high;
    for (std::size_t n = found[e].place; n < last && !high; ++n)
      if (beyond(searched[n + 1]) >= 0)
        high = bracketed_root(beyond, extremum.frequency, searched[n + 1]);
    if (low && high) extremum.damping_ratio = (*high - *low) / (2 * extremum.frequency);  // (DY-13)
  }
  std::vector<ResponseExtremum> extrema;
  for (const Found& one : found)
    if (one.shown) extrema.push_back(one.extremum);
  return extrema;
}

}  // namespace strainwave
