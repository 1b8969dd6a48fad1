// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string_view>

/// @file
/// Accuracy of the models: one standard relative uncertainty of each, with its basis.  It covers
/// the form of the model alone; the inputs are taken as exact.  Theory manual, table ST-1.

namespace strainwave {

/// One standard relative uncertainty of a model, and its basis.
struct ModelAccuracy {
  /// one standard uncertainty of the model's form, over the value [-]
  double relative_uncertainty = 0.0;
  std::string_view source;  ///< what the number rests on, in words

  /// The relative uncertainty [-].  The conversion is implicit, so an accuracy can be used as a
  /// plain number.
  constexpr operator double() const {  // NOLINT(google-explicit-constructor)
    return relative_uncertainty;
  }
};

}  // namespace strainwave

namespace strainwave::accuracy {

/// Uncertainty of the compliance of a round tube (ST-2), and of a cylinder without a factor (ST-4)
/// [-].
inline constexpr ModelAccuracy kTube{
    0.01, "the solution is exact for a tube; ends, fillets and splines are left out"};
/// Uncertainty of the compliance of a flexspline by a factor, whatever its value (ST-4) [-].
inline constexpr ModelAccuracy kShapeFactor{
    2.0,
    "the same accuracy for any factor: sixteen cups in finite elements are 1.06 to 11 times as "
    "compliant as their barrel; eleven of these cups agree within 200 % with the factor 0.83, and "
    "twelve with the factor 1"};
/// Uncertainty of the compliance of a flexspline by its sections, (ST-2) and (ST-3) [-].
inline constexpr ModelAccuracy kSections{
    0.05, "1.1 % against finite elements with sharp corners; fillets and teeth are left out"};
/// Uncertainty of the lobe force (ST-5) [-]; it enters a compliance with a power, see `power`.
inline constexpr ModelAccuracy kLobeForce{0.15, "lobe force: c_F between 1 and 1.15"};
/// Uncertainty of the compliances of wave generator and race cracks by the cam conversion (ST-7)
/// [-].
inline constexpr ModelAccuracy kCamConversion{
    0.70, "cam conversion: reciprocity gives a result different by a factor of about 1.7"};
/// Accuracy of the compliance of wave generator and flexspline, (ST-18).
inline constexpr ModelAccuracy kContactsLeftOut{
    4.0, "contacts, rings and coning are left out: 2 to 5 times too stiff against catalogues"};
/// Uncertainty of the compliance of a lobe from the contacts of its balls (ST-9) [-].
inline constexpr ModelAccuracy kLoadSharing{
    0.30, "the balls are assumed to share the lobe force equally"};
/// Uncertainty of the compliance of a surface crack in a wall or a race (FR-4) [-].
inline constexpr ModelAccuracy kSurfaceCrack{
    0.10, "Newman and Raju: 5 % of K against finite elements, so 10 % of the compliance"};
/// Uncertainty of the compliance of a surface crack deeper than 0.7 of the wall, in place of
/// kSurfaceCrack [-].
inline constexpr ModelAccuracy kSurfaceCrackDeep{
    0.16, "Newman and Raju beyond a/t = 0.7: 8 % of K against finite elements in a tube"};
/// Uncertainty f_w^2 - 1 of a crack longer than half of the ring's width, from its width factor
/// f_w.
inline constexpr std::string_view kBeyondWidthRange =
    "width factor f_w beyond c/b = 0.5: f_w^2 - 1 of the compliance";
/// Uncertainty of the compliance of a surface crack by its shear (FR-10) [-], beside that of its
/// opening.
inline constexpr ModelAccuracy kSurfaceCrackShear{
    0.20, "K_II and K_III of an embedded ellipse, without the free surface"};
/// Uncertainty of the compliance of a surface crack outside of the fitted range, in place of
/// kSurfaceCrack [-].
inline constexpr ModelAccuracy kSurfaceCrackExtrapolated{
    0.20, "Newman and Raju beyond a/t = 0.8 or below a/c = 0.2"};
/// Uncertainty of the compliance of an edge crack of a race (FR-11) [-].
inline constexpr ModelAccuracy kEdgeCrack{
    0.20, "the model is a strip with free ends, but the cam supports the ring"};
/// Uncertainty of the compliance of an open through crack of a wall (FR-7), shell parameter up to 2
/// [-].
inline constexpr ModelAccuracy kThroughCrack{
    0.02, "curved wall, open: within 1.1 % of finite elements, r/t 20 to 60"};
/// Uncertainty of the compliance of an open through crack of a wall, shell parameter from 2 to 4
/// [-].
inline constexpr ModelAccuracy kThroughCrackLong{
    0.03, "curved wall at a shell parameter of 2 to 4, open: within 1.3 % of finite elements"};
/// The code multiplies this value by (2a/L)^2.
inline constexpr ModelAccuracy kThroughCrackBetweenJoints{
    0.16,
    "ends left out: half-way between rim and diaphragm, finite elements are softer by a term in "
    "(2a/L)^2"};
/// Uncertainty of the compliance of a through crack in any section but a barrel between rim and
/// diaphragm [-].  The code multiplies this value by (2a/L)^2.
inline constexpr ModelAccuracy kThroughCrackNearFreeEnd{
    0.50,
    "ends left out: half-way to a free end, finite elements are softer by a term in (2a/L)^2"};
/// Uncertainty of the entries of the compliance of a through crack with the axial force [-], beside
/// the other uncertainties.
inline constexpr ModelAccuracy kThroughCrackAxial{
    0.05,
    "curved wall under axial force: the same shell theory, but not compared with finite elements"};
/// Uncertainty of the compliance of a through crack whose faces are pressed together [-], beside
/// the other uncertainties.
inline constexpr ModelAccuracy kThroughCrackPressed{
    0.02, "pressed faces slide without friction: 1 % of compliance, 2 % of G in finite elements"};
/// Uncertainty of the compliance of a row of open through cracks (CG-8), in its table [-].
inline constexpr ModelAccuracy kRowOfCracks{
    0.05, "row of cracks in a curved wall: 2 % to solid elements, 4 % between nodes of a table"};
/// Uncertainty of the compliance of a row whose curvature between the cracks is left out, for close
/// cracks and shell parameters from 0.8 to 2; beyond, twice as much [-].
inline constexpr ModelAccuracy kRowInFlatSheet{
    0.20, "neighbours as in a flat sheet: the curvature between the cracks is left out"};
/// Uncertainty of K of a through crack (FR-7) [-].
inline constexpr ModelAccuracy kThroughCrackIntensity{
    0.12, "K of a sheet: finite elements differ by up to 12 % of K for Poisson's ratios up to 0.3"};
/// Uncertainty of K of a through crack at a Poisson's ratio above 0.3, in place of
/// kThroughCrackIntensity [-].
inline constexpr ModelAccuracy kThroughCrackIntensityOtherRatio{
    0.20,
    "K of a sheet: finite elements differ by 19 % in the middle of the wall at Poisson's ratio "
    "0.45"};
/// Uncertainty of the compliance of an annular crack in tension at another Poisson's ratio than 0.3
/// [-].
inline constexpr ModelAccuracy kAnnularTensionOtherRatio{
    0.03, "fits and table are for Poisson's ratio 0.3; the error is 2.5 % at 0 and 0.45"};
/// The code adds the part that the curvature of an isotropic wall would have.
inline constexpr ModelAccuracy kLaminateCrack{
    0.10, "flat, thin, anisotropic sheet: a state of plane stress through the wall is assumed"};
/// Uncertainty of the torsional compliance of a tube of a laminate (LA-5) [-].
inline constexpr ModelAccuracy kLaminateTube{
    0.02, "thin wall of perfectly bonded plies, free to lengthen and to widen; ends are left out"};
/// Uncertainty of the compliance of an arc crack of the diaphragm (TC-19) [-].
inline constexpr ModelAccuracy kDiaphragmArc{
    0.10, "a straight crack in a flat plate under uniform shear"};
/// Uncertainty of the compliance of a groove of the diaphragm (TC-20) [-].
inline constexpr ModelAccuracy kDiaphragmGroove{
    0.20, "the model uses the local thickness only; the corners of the groove are left out"};
/// Uncertainty of the compliance of an annular crack in torsion, (FR-12) and (FR-14) [-].
inline constexpr ModelAccuracy kAnnularTorsion{
    0.002, "fits and table are within 0.04 % of independent computations of the sharp crack"};
/// Uncertainty of the compliance of an annular crack in tension, (FR-13) and (FR-15) [-].
inline constexpr ModelAccuracy kAnnularTension{
    0.005, "fits and table are within 0.3 % of independent computations, Poisson's ratio 0.3"};
/// Uncertainty of the compliance of an annular crack in tension, in a wall thinner than that of the
/// table [-].
inline constexpr ModelAccuracy kAnnularExtrapolated{
    1.0, "extrapolated beyond the table in tension, r_i/r_o <= 0.95"};
/// Uncertainty of the compliance of an annular crack of a solid shaft by the handbook's
/// polynomials, in torsion and in tension [-].
inline constexpr ModelAccuracy kAnnularTada{
    0.055, "handbook polynomials: 3.6 % in torsion, 5.4 % in tension against finite elements"};
/// Uncertainty of the compliance of a surface crack of a solid shaft in torsion (FR-22) [-].
inline constexpr ModelAccuracy kSolidSurfaceTorsion{
    0.05, "within 3.5 % of the energy of finite elements of the shaft, Poisson's ratio 0.3"};
/// Uncertainty of the compliance of a surface crack of a solid shaft in tension (FR-22) [-].
inline constexpr ModelAccuracy kSolidSurfaceTension{
    0.02, "within 0.7 % of the energy of finite elements of the shaft, Poisson's ratio 0.3"};
/// Uncertainty of the compliance of a surface crack of a solid shaft at another Poisson's ratio
/// than 0.3 [-].
inline constexpr ModelAccuracy kSolidSurfaceOtherRatio{
    0.30, "the table is for Poisson's ratio 0.3; K_III of an ellipse changes by 14 % to 0.45"};
/// Uncertainty of the compliance of a surface crack of a hollow shaft in torsion [-].
inline constexpr ModelAccuracy kHollowSurfaceTorsion{
    0.15, "an embedded ellipse: within 13 % of the energy of finite elements of the shaft"};
/// Uncertainty of the compliance of a surface crack of a hollow shaft in tension [-].
inline constexpr ModelAccuracy kHollowSurfaceTension{
    0.15, "the wall as a plate: within 14 % of the energy of finite elements of the shaft"};
/// Uncertainty of the compliance of a surface crack of a shaft outside of the compared range [-].
inline constexpr ModelAccuracy kShaftSurfaceExtrapolated{
    0.50, "a surface crack of a shaft beyond the sizes that were compared with finite elements"};
/// Uncertainty of the stress of a race crack by the orthogonal shear (ST-12) [-]; the compliance
/// has twice it.
inline constexpr ModelAccuracy kOrthogonalShear{
    1.0,
    "the driver treats a subsurface shear as a hoop tension, which gives an order of magnitude at "
    "best"};
/// Uncertainty of the stress of a race crack by the tension at the edge of the contact (CO-7) [-].
inline constexpr ModelAccuracy kContactEdge{
    0.50, "the edge tension decays within the contact, but is assumed uniform"};
/// Uncertainty of the stress of a race crack by the bending of the ring (ST-13) [-].
inline constexpr ModelAccuracy kRingBending{
    0.30, "the model is a free ring; the cam inside it is left out"};
/// Uncertainty of the stress of a race crack that the file gives [-].
inline constexpr ModelAccuracy kGivenStress{0.10,
                                            "the given stress is assumed uniform over the crack"};

/// Relative uncertainty of K_I of the hollow shaft, from the slope of an interpolated table.  It
/// was measured against a solid shaft and between the nodes.
inline constexpr double kHollowTensionIntensity = 0.015;
/// Relative uncertainty of K_III of the hollow shaft, found in the same way; 0.11 % at the end of
/// the table, a/t = 0.8.
inline constexpr double kHollowTorsionIntensity = 0.0015;

/// Relative uncertainty of K_I of a surface crack in a solid shaft [-], (SB-7).
inline constexpr double kSolidSurfaceOpening = 0.03;
/// Relative uncertainty of K_II and K_III of a surface crack in a solid shaft [-], (SB-7).
inline constexpr double kSolidSurfaceShear = 0.05;
/// Relative uncertainty of K_I of a surface crack in a hollow shaft [-], (SB-10).
inline constexpr double kHollowSurfaceOpening = 0.08;
/// Relative uncertainty of K_II and K_III of a surface crack in a hollow shaft [-], (SB-11).
inline constexpr double kHollowSurfaceShear = 0.20;

/// The relative uncertainty of a result that is proportional to the n-th power of a quantity [-].
[[nodiscard]] constexpr ModelAccuracy power(const ModelAccuracy& accuracy, double n) {
  return {n * accuracy.relative_uncertainty, accuracy.source};
}

/// Root of the sum of squares of independent relative uncertainties [-].
[[nodiscard]] inline double combined(double a, double b) { return std::hypot(a, b); }

}  // namespace strainwave::accuracy
