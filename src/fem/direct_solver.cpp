// SPDX-License-Identifier: Apache-2.0
#include "direct_solver.hpp"

#include <dlfcn.h>
#include <dmumps_c.h>
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/memory_error.hpp"

// NOLINTBEGIN(readability-identifier-naming): names of LAPACK
extern "C" {
void dsyrk_(const char*, const char*, const int*, const int*, const double*, const double*,
            const int*, const double*, double*, const int*);
void dtrsm_(const char*, const char*, const char*, const char*, const int*, const int*,
            const double*, const double*, const int*, double*, const int*);
void dpotrf_(const char*, const int*, double*, const int*, int*);
}
// NOLINTEND(readability-identifier-naming)

namespace strainwave::fem {
namespace {
constexpr int kSingular = -10;  // code of MUMPS for a singular matrix
}

/// The data of MUMPS, which must be released by a call.
struct DirectSolver::Mumps {
  Mumps() {
    id_.par = 1;  // the first rank also computes
    id_.sym = 1;  // matrix is positive definite
    id_.comm_fortran = MPI_Comm_c2f(MPI_COMM_WORLD);
    run(kStart);
    for (const int silent : {1, 2, 3, 4}) control(silent) = silent == 4 ? 0 : -1;
    control(18) = 3;  // every rank provides its entries
    control(28) = 1;  // one rank chooses the order, so it is the same for any number of ranks
    control(7) = 5;   // order by METIS
  }
  ~Mumps() {
    id_.job = kEnd;
    dmumps_c(&id_);
  }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  static constexpr int kStart = -1;
  static constexpr int kEnd = -2;
  static constexpr int kAnalyse = 1;
  static constexpr int kFactor = 2;
  static constexpr int kSolve = 3;

  /// A control parameter, numbered as in the manual of MUMPS.
  int& control(int i) { return id_.icntl[i - 1]; }

  void run(int job) {
    id_.job = job;
    dmumps_c(&id_);
    check_mumps(id_.infog[0], id_.infog[1]);
  }

  /// Factors the matrix.  Repeats with a larger workspace if that of the analysis is too small.
  void factor() {
    constexpr int kMostPercent = 1000;
    for (int more = std::max(100, 2 * control(14));; more *= 2) {
      id_.job = kFactor;
      dmumps_c(&id_);
      const int code = id_.infog[0];
      const bool short_of_space = code == -8 || code == -9 || code == -17 || code == -20;
      if (!short_of_space || more > kMostPercent) break;
      ++repeats_;
      control(14) = more;  // per cent above the estimate
    }
    const bool indefinite = id_.infog[0] >= 0 && id_.infog[11] > 0;  // a pivot is negative
    check_mumps(indefinite ? kSingular : id_.infog[0], id_.infog[1]);
  }

  DMUMPS_STRUC_C id_{};
  int repeats_ = 0;
};

void check_mumps(int code, int detail) {
  if (code >= 0) return;
  if (code == kSingular)
    throw SolverError(
        "the direct solver failed: the supports leave a rigid-body motion free; hold the body "
        "completely");
  if (code == -13 || code == -7 || code == -5 || code == -19)
    throw MemoryError(
        "the direct solver failed because the memory does not suffice; use a coarser mesh or more "
        "ranks");
  throw Error(fmt::format("the direct solver failed (code {}, {})", code, detail));
}

void SymmetricEntries::reserve(std::size_t size) {
  row.reserve(size);
  column.reserve(size);
  value.reserve(size);
}

DirectSolver::DirectSolver(SymmetricEntries entries, int unknowns,
                           std::optional<int> workspace_percent) {
  if (unknowns == 0) return;  // all unknowns were eliminated in the cells
  mumps_ = std::make_unique<Mumps>();
  if (workspace_percent) mumps_->control(14) = *workspace_percent;
  DMUMPS_STRUC_C& data = mumps_->id_;
  data.n = unknowns;
  data.nnz_loc = static_cast<MUMPS_INT8>(entries.value.size());
  data.irn_loc = entries.row.data();
  data.jcn_loc = entries.column.data();
  data.a_loc = entries.value.data();
  mumps_->run(Mumps::kAnalyse);
  mumps_->factor();
  // MUMPS has its factor and does not read the entries again, so they are released here.
  data.irn_loc = nullptr;
  data.jcn_loc = nullptr;
  data.a_loc = nullptr;
}

DirectSolver::~DirectSolver() = default;

std::vector<double> DirectSolver::solve(std::vector<double> rhs, int count) {
  if (!mumps_) return rhs;
  DMUMPS_STRUC_C& data = mumps_->id_;
  data.rhs = rhs.data();
  data.nrhs = count;
  data.lrhs = data.n;
  mumps_->run(Mumps::kSolve);
  MPI_Bcast(rhs.data(), static_cast<int>(rhs.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return rhs;
}

double DirectSolver::megabytes() const {
  return mumps_ ? static_cast<double>(mumps_->id_.infog[21]) : 0.0;
}

double DirectSolver::operations() const { return mumps_ ? mumps_->id_.rinfog[2] : 0.0; }

int DirectSolver::repeats() const { return mumps_ ? mumps_->repeats_ : 0; }

// The names below are looked up at run time.  They exist only in OpenBLAS, and the system chooses
// the BLAS; a link-time reference would tie the program to OpenBLAS.  OpenBLAS selects its kernels
// when it is loaded, so a new selection requires unloading and loading it again.  It takes its
// setting only from the environment, so the variable is set for that moment.  No other thread
// exists yet that could read the environment, because MpiSession calls this function first.
void prepare_blas() {
  const auto function = [](const char* name) { return dlsym(RTLD_DEFAULT, name); };
  if (!std::getenv("OMP_NUM_THREADS") && !std::getenv("OPENBLAS_NUM_THREADS"))
    if (void* const threads = function("openblas_set_num_threads"))
      reinterpret_cast<void (*)(int)>(threads)(1);
#ifdef __x86_64__
  void* const named = function("gotoblas_corename");
  void* const forget = function("gotoblas_dynamic_quit");
  void* const choose = function("gotoblas_dynamic_init");
  if (!named || !forget || !choose || std::getenv("OPENBLAS_CORETYPE")) return;
  if (reinterpret_cast<const char* (*)()>(named)() != std::string_view("Prescott")) return;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return;
  const bool skylake = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                       __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
                       __builtin_cpu_supports("avx512cd");
  setenv("OPENBLAS_CORETYPE", skylake ? "SkylakeX" : "Haswell", 0);
  reinterpret_cast<void (*)()>(forget)();
  reinterpret_cast<void (*)()>(choose)();
  unsetenv("OPENBLAS_CORETYPE");
#endif
}

Eigen::MatrixXd lower_square(const Eigen::MatrixXd& a) {
  const int n = static_cast<int>(a.rows());
  const int k = static_cast<int>(a.cols());
  const double one = 1;
  const double zero = 0;
  Eigen::MatrixXd square(n, n);
  dsyrk_("L", "N", &n, &k, &one, a.data(), &n, &zero, square.data(), &n);
  return square;
}

CondensedMatrix condense(const Eigen::MatrixXd& stiffness, Eigen::Index inner) {
  const Eigen::Index outer = stiffness.rows() - inner;
  CondensedMatrix result{.factor = stiffness.topLeftCorner(inner, inner),
                         .coupling = stiffness.bottomLeftCorner(outer, inner).transpose(),
                         .outer = stiffness.bottomRightCorner(outer, outer)};
  if (inner == 0) return result;
  const int i = static_cast<int>(inner);
  const int o = static_cast<int>(outer);
  int info = 0;
  dpotrf_("L", &i, result.factor.data(), &i, &info);
  if (info != 0)
    throw SolverError("a cell's stiffness is not positive definite: the mesh is tangled");
  if (outer == 0) return result;
  const double one = 1;
  const double minus_one = -1;
  dtrsm_("L", "L", "N", "N", &i, &o, &one, result.factor.data(), &i, result.coupling.data(), &i);
  dsyrk_("L", "T", &o, &i, &minus_one, result.coupling.data(), &i, &one, result.outer.data(),
         &o);  // (FE-45)
  return result;
}

}  // namespace strainwave::fem
