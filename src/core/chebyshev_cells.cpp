// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/chebyshev_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

namespace strainwave {
namespace {

constexpr std::size_t N = ChebyshevCells::kNodes;
using Row = std::array<double, N>;

/// cos((2 i + 1) k pi/(2 N)), the polynomial T_k at node i.
const std::array<Row, N>& polynomials_at_nodes() {
  static const auto made = [] {
    std::array<Row, N> T{};
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = 0; k < N; ++k)
        T[i][k] = std::cos(static_cast<double>((2 * i + 1) * k) * std::numbers::pi / (2 * N));
    return T;
  }();
  return made;
}

Row polynomials(double x) {
  Row T;
  T[0] = 1;
  T[1] = x;
  for (std::size_t k = 2; k < N; ++k) T[k] = 2 * x * T[k - 1] - T[k - 2];
  return T;
}

/// Replaces values at the nodes along one variable by coefficients.
/// @param stride  distance of neighbours along the variable
void transform(std::span<double> values, std::size_t stride) {
  const auto& T = polynomials_at_nodes();
  for (std::size_t first = 0; first < values.size(); ++first) {
    if (first / stride % N != 0) continue;
    Row coefficients{};
    for (std::size_t k = 0; k < N; ++k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < N; ++i) sum += T[i][k] * values[first + i * stride];
      coefficients[k] = sum * (k == 0 ? 1.0 : 2.0) / N;
    }
    for (std::size_t k = 0; k < N; ++k) values[first + k * stride] = coefficients[k];
  }
}

/// Two neighbours in one register of any 64-bit processor.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

/// Sums coefficients over the slowest of their variables.  The order of each sum is that of its
/// terms, so its bits do not depend on how many sums run at once.
/// @tparam Size  number of sums, which are contiguous for each value of that variable
template <std::size_t Size>
void contract(const Row& T, const double* coefficients, double* sums) {
  if constexpr (Size == 1) {
    double sum = 0.0;
    for (std::size_t k = 0; k < N; ++k) sum += T[k] * coefficients[k];
    *sums = sum;
  } else {
    constexpr std::size_t kPairs = N / 2;  // registers for the sums of a block
    static_assert(Size % N == 0);
    for (std::size_t first = 0; first < Size; first += N) {
      std::array<Pair, kPairs> sum{};
      for (std::size_t k = 0; k < N; ++k)
        for (std::size_t n = 0; n < kPairs; ++n) {
          Pair two;
          std::memcpy(&two, coefficients + k * Size + first + 2 * n, sizeof(two));
          sum[n] += T[k] * two;
        }
      std::memcpy(sums + first, sum.data(), sizeof(sum));
    }
  }
}

}  // namespace

/// A box, or a part of a halved box.
struct ChebyshevCells::Cell {
  enum class State : unsigned char { polynomial, halved, none };

  Place centre{};
  Place half{};  ///< half widths
  int halvings = 0;
  std::once_flag filling;
  std::atomic<bool> filled = false;  ///< tells a reader to skip `filling`, which takes longer
  State state = State::none;
  std::size_t along = 0;  ///< the variable along which the cell is halved
  std::array<std::unique_ptr<Cell>, 2> halves;
  std::vector<double> coefficients;  ///< value after value; the last variable changes fastest
};

ChebyshevCells::ChebyshevCells(Function function, Options options)
    : function_(std::move(function)),
      options_(std::move(options)),
      variables_(options_.widths.size()),
      nodes_(1) {
  for (std::size_t v = 0; v < variables_; ++v) nodes_ *= N;
}

ChebyshevCells::~ChebyshevCells() = default;

std::size_t ChebyshevCells::HashOfBox::operator()(const Box& box) const {
  std::uint64_t hash = 0;
  for (const std::int64_t index : box)
    hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 32U);
}

ChebyshevCells::Box ChebyshevCells::box_of(const Place& place) const {
  Box box{};
  for (std::size_t v = 0; v < variables_; ++v)
    box[v] = static_cast<std::int64_t>(std::floor(place[v] / options_.widths[v]));
  return box;
}

ChebyshevCells::Cell& ChebyshevCells::root(const Box& box) {
  const std::scoped_lock lock(mutex_);
  Cell*& known = roots_[box];
  if (known == nullptr) {
    owned_.push_back(std::make_unique<Cell>());
    known = owned_.back().get();
    for (std::size_t v = 0; v < variables_; ++v) {
      known->half[v] = options_.widths[v] / 2;
      known->centre[v] = (static_cast<double>(box[v]) + 0.5) * options_.widths[v];
    }
  }
  return *known;
}

bool ChebyshevCells::evaluate(const Place& place, Values& values) const {
  ++evaluations_;
  return function_(place, values) &&
         std::all_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(options_.values),
                     [](double value) { return std::isfinite(value); });
}

void ChebyshevCells::fill(Cell& cell) {
  const auto& T = polynomials_at_nodes();
  std::vector<double> table(nodes_ * options_.values);
  for (std::size_t n = 0; n < nodes_; ++n) {
    Place place{};
    for (std::size_t v = variables_, rest = n; v-- > 0; rest /= N)
      place[v] = cell.centre[v] + cell.half[v] * T[rest % N][1];
    Values values{};
    if (!evaluate(place, values)) return;
    for (std::size_t p = 0; p < options_.values; ++p) table[p * nodes_ + n] = values[p];
  }
  // (ST-22): the highest coefficients along a variable say whether it is resolved.
  double worst = 0.0;
  Values largest_values{};
  for (std::size_t p = 0; p < options_.values; ++p) {
    const std::span<double> of = std::span(table).subspan(p * nodes_, nodes_);
    double& largest = largest_values[p];
    for (const double value : of) largest = std::max(largest, std::abs(value));
    std::size_t stride = 1;
    for (std::size_t v = variables_; v-- > 0; stride *= N) transform(of, stride);
    for (std::size_t v = variables_; v-- > 0;) {
      stride /= N;
      double tail = 0.0;
      for (std::size_t n = 0; n < nodes_; ++n)
        if (n / stride % N == N - 1) tail = std::max(tail, std::abs(of[n]));
      const std::size_t variable = variables_ - 1 - v;
      if (largest > 0 && tail / largest > worst) {
        worst = tail / largest;
        cell.along = variable;
      }
    }
  }
  if (worst <= options_.tolerance / 4 && keep(cell, std::move(table), largest_values)) return;
  if (cell.halvings == options_.halvings) return;
  for (const std::size_t side : {0U, 1U}) {
    auto half = std::make_unique<Cell>();
    half->centre = cell.centre;
    half->half = cell.half;
    half->half[cell.along] /= 2;
    half->centre[cell.along] += (side == 0 ? -1 : 1) * half->half[cell.along];
    half->halvings = cell.halvings + 1;
    cell.halves[side] = std::move(half);
  }
  cell.state = Cell::State::halved;
}

/// Makes the cell a polynomial if it agrees with the function between the nodes.
bool ChebyshevCells::keep(Cell& cell, std::vector<double> coefficients, const Values& largest) {
  double error = 0.0;
  cell.coefficients = std::move(coefficients);
  cell.state = Cell::State::polynomial;
  // Irrational shares of the widths, so that no place is a node.
  for (const double share : {-0.9433, -0.31831, 0.17157, 0.70711}) {
    Place place{};
    for (std::size_t v = 0; v < variables_; ++v)
      place[v] = cell.centre[v] + cell.half[v] * (v == 1 ? -share * 0.97 : share);
    Values exact{};
    Values read_values{};
    if (!evaluate(place, exact) || !read(cell, place, read_values)) {
      error = HUGE_VAL;
      break;
    }
    for (std::size_t p = 0; p < options_.values; ++p)
      if (largest[p] > 0) error = std::max(error, std::abs(read_values[p] - exact[p]) / largest[p]);
  }
  if (error > options_.tolerance) {
    cell.state = Cell::State::none;
    return false;
  }
  double before = largest_error_;
  while (before < error && !largest_error_.compare_exchange_weak(before, error)) {
  }
  return true;
}

bool ChebyshevCells::read(Cell& cell, const Place& place, Values& values) {
  if (cell.state == Cell::State::none) return false;
  std::array<Row, kMaxVariables> T;
  for (std::size_t v = 0; v < variables_; ++v)
    T[v] = polynomials((place[v] - cell.centre[v]) / cell.half[v]);
  std::array<double, N * N> planes;
  std::array<double, N> rows;
  for (std::size_t p = 0; p < options_.values; ++p) {
    const double* of = cell.coefficients.data() + p * nodes_;
    std::size_t v = 0;
    if (variables_ == 3) {
      contract<N * N>(T[v++], of, planes.data());
      of = planes.data();
    }
    if (variables_ >= 2) {
      contract<N>(T[v++], of, rows.data());
      of = rows.data();
    }
    contract<1>(T[v], of, &values[p]);
  }
  return true;
}

bool ChebyshevCells::Reader::operator()(const Place& place, Values& values) {
  const Box box = cells_->box_of(place);
  if (last_ == nullptr || box != last_box_) {
    const auto [known, is_new] = known_.try_emplace(box, nullptr);
    if (is_new) known->second = &cells_->root(box);
    last_ = known->second;
    last_box_ = box;
  }
  for (Cell* cell = last_;;) {
    if (!cell->filled.load(std::memory_order_acquire)) {
      std::call_once(cell->filling, [&] { cells_->fill(*cell); });
      cell->filled.store(true, std::memory_order_release);
    }
    if (cell->state != Cell::State::halved) return cells_->read(*cell, place, values);
    cell = cell->halves[place[cell->along] < cell->centre[cell->along] ? 0 : 1].get();
  }
}

}  // namespace strainwave
