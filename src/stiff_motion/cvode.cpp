// SPDX-License-Identifier: Apache-2.0
#include "cvode.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr int kMostFailures = 50;  // of one step

/// A C object with the function that frees it.
template <class Object>
using Owned = std::unique_ptr<Object, void (*)(Object*)>;

using Context = Owned<std::remove_pointer_t<SUNContext>>;
using Vector = Owned<std::remove_pointer_t<N_Vector>>;
using Matrix = Owned<std::remove_pointer_t<SUNMatrix>>;
using Solver = Owned<std::remove_pointer_t<SUNLinearSolver>>;

Context new_context() {
  SUNContext made = nullptr;
  if (SUNContext_Create(nullptr, &made) != 0) made = nullptr;
  return {made, [](SUNContext context) { (void)SUNContext_Free(&context); }};
}

template <class Object>
Owned<Object> sound(Owned<Object> object) {
  if (!object) throw SolverError("CVODE has no memory; close other programs");
  return object;
}

std::span<double> values_of(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<std::size_t>(N_VGetLength(vector))};
}

}  // namespace

struct Cvode::Memory {
  explicit Memory(System with)
      : system(std::move(with)),
        context(sound(new_context())),
        state(vector(system.tolerance.size())),
        matrix(sound(Matrix{SUNDenseMatrix(size(), size(), context.get()), SUNMatDestroy})),
        solver(sound(Solver{SUNLinSol_Dense(state.get(), matrix.get(), context.get()),
                            [](SUNLinearSolver of) { (void)SUNLinSolFree(of); }})),
        cvode(sound(
            Owned<void>{CVodeCreate(CV_BDF, context.get()), [](void* of) { CVodeFree(&of); }})) {}

  [[nodiscard]] sunindextype size() const {
    return static_cast<sunindextype>(system.tolerance.size());
  }
  [[nodiscard]] Vector vector(std::size_t entries) const {
    return sound(
        Vector{N_VNew_Serial(static_cast<sunindextype>(entries), context.get()), N_VDestroy});
  }
  /// The counts of CVODE begin anew with each `begin`.
  [[nodiscard]] Counts counts() const {
    long made = 0;
    long by_error = 0;
    long by_newton = 0;
    (void)CVodeGetNumSteps(cvode.get(), &made);
    (void)CVodeGetNumErrTestFails(cvode.get(), &by_error);
    (void)CVodeGetNumStepSolveFails(cvode.get(), &by_newton);
    return {before.steps + static_cast<std::uint64_t>(made),
            before.rejected + static_cast<std::uint64_t>(by_error + by_newton)};
  }

  /// Calls a function of the system from C, through which no exception may pass.
  template <class Call>
  static int guarded(void* memory, const Call& call) {
    auto& self = *static_cast<Memory*>(memory);
    try {
      call(self.system);
      return 0;
    } catch (...) {
      self.thrown = std::current_exception();
      return -1;
    }
  }
  static int rate(double time, N_Vector x, N_Vector dx, void* memory) {
    const int status =
        guarded(memory, [&](const System& of) { of.rate(time, values_of(x), values_of(dx)); });
    if (status != 0) return status;
    const std::span<const double> made = values_of(dx);
    // A shorter step may mend it.
    return std::ranges::all_of(made, [](double value) { return std::isfinite(value); }) ? 0 : 1;
  }
  static int guards(double time, N_Vector x, double* values, void* memory) {
    return guarded(memory, [&](const System& of) {
      of.guards(time, values_of(x), {values, of.guard_count});
    });
  }

  System system;
  Context context;
  Vector state;
  Matrix matrix;
  Solver solver;
  Owned<void> cvode;
  std::exception_ptr thrown = {};
  double end = 0.0;
  Counts before = {};
};

Cvode::Cvode(System system) : memory_(std::make_unique<Memory>(std::move(system))) {
  Memory& m = *memory_;
  void* const cvode = m.cvode.get();
  const auto demand = [](int status) {
    if (status != CV_SUCCESS) throw SolverError("CVODE refuses its settings");
  };
  N_VConst(0.0, m.state.get());
  demand(CVodeInit(cvode, Memory::rate, 0.0, m.state.get()));
  const Vector tolerance = m.vector(m.system.tolerance.size());
  std::ranges::copy(m.system.tolerance, values_of(tolerance.get()).begin());
  demand(CVodeSVtolerances(cvode, 0.0, tolerance.get()));
  demand(CVodeSetUserData(cvode, &m));
  demand(CVodeSetLinearSolver(cvode, m.solver.get(), m.matrix.get()));
  demand(CVodeRootInit(cvode, static_cast<int>(m.system.guard_count), Memory::guards));
  // A joint that stood still may jump within a millionth of the last step.
  demand(CVodeSetMaxErrTestFails(cvode, kMostFailures));
  demand(CVodeSetMaxConvFails(cvode, kMostFailures));
  demand(CVodeSetNoInactiveRootWarn(cvode));
  demand(CVodeSetErrHandlerFn(
      cvode, [](int, const char*, const char*, char*, void*) {}, nullptr));
}

Cvode::~Cvode() = default;

void Cvode::begin(double time, std::span<const double> state, double end) {
  memory_->before = memory_->counts();
  std::ranges::copy(state, values_of(memory_->state.get()).begin());
  void* const cvode = memory_->cvode.get();
  (void)CVodeReInit(cvode, time, memory_->state.get());
  (void)CVodeSetStopTime(cvode, end);
  memory_->end = end;
}

Cvode::Step Cvode::step(double longest) {
  Memory& m = *memory_;
  (void)CVodeSetMaxStep(m.cvode.get(), std::isfinite(longest) ? longest : 0.0);
  Step made;
  const int status = CVode(m.cvode.get(), m.end, m.state.get(), &made.time, CV_ONE_STEP);
  if (m.thrown) std::rethrow_exception(std::exchange(m.thrown, nullptr));
  made.failed = status < 0;
  if (status != CV_ROOT_RETURN) return made;
  std::vector<int> changed(m.system.guard_count);
  (void)CVodeGetRootInfo(m.cvode.get(), changed.data());
  for (std::size_t n = 0; n < changed.size(); ++n)
    if (changed[n] != 0) made.changed.push_back(n);
  return made;
}

std::span<const double> Cvode::state() const { return values_of(memory_->state.get()); }

std::vector<double> Cvode::state_at(double time) const {
  const Vector at = memory_->vector(memory_->system.tolerance.size());
  (void)CVodeGetDky(memory_->cvode.get(), time, 0, at.get());
  const std::span<const double> values = values_of(at.get());
  return {values.begin(), values.end()};
}

Cvode::Counts Cvode::counts() const { return memory_->counts(); }

}  // namespace strainwave
