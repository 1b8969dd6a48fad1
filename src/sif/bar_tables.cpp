// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "strainwave/core/lagrange.hpp"
#include "strainwave/core/polynomial.hpp"
#include "strainwave/sif/bar/tables.hpp"

namespace strainwave::sif {
namespace {

template <std::size_t N, std::size_t M>
using Grid = std::array<std::array<double, M>, N>;

template <std::size_t N, std::size_t M>
double interpolate(const Grid<N, M>& grid, const std::array<double, N>& row,
                   const std::array<double, M>& column) {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < M; ++j) sum += row[i] * column[j] * grid[i][j];
  return sum;
}

// Nodes are Lobatto-Chebyshev points of the depth a/t, and of q = sqrt(1 - r_i/r_o) over its
// largest value.  Columns are depths; the first is the edge crack, the first row the strip.
// tools/reference/ annular_fourier.py --library.  clang-format off
constexpr std::array<double, 9> kDepth = {
    0,   0.0304481869954853, 0.117157287525381, 0.246926627053964,
    0.4, 0.553073372946036,  0.682842712474619, 0.769551813004515,
    0.8};
constexpr std::array<double, 8> kWall = {0,
                                         0.0495155660487905,
                                         0.188255099070633,
                                         0.388739533021843,
                                         0.611260466978157,
                                         0.811744900929367,
                                         0.95048443395121,
                                         1};
constexpr Grid<8, 9> kOuterBending = {
    {{1.121522, 1.128549, 1.212345, 1.488641, 2.111582, 3.380095, 5.823399, 9.597072, 11.956668},
     {1.121522, 1.128094, 1.206990, 1.461789, 2.007660, 2.998633, 4.495008, 6.017320, 6.643999},
     {1.121522, 1.127125, 1.192629, 1.393360, 1.776123, 2.338071, 2.958356, 3.420575, 3.587068},
     {1.121522, 1.125678, 1.173479, 1.313424, 1.559936, 1.894831, 2.266797, 2.592566, 2.735236},
     {1.121522, 1.124313, 1.158346, 1.264290, 1.467293, 1.781824, 2.199010, 2.630389, 2.835815},
     {1.121522, 1.123774, 1.158303, 1.286060, 1.574907, 2.107478, 2.946689, 3.938643, 4.442574},
     {1.121522, 1.124412, 1.173959, 1.372346, 1.878922, 3.019128, 5.386106, 9.147031, 11.474385},
     {1.121522, 1.125023, 1.184954, 1.428677, 2.088258, 3.763207, 8.007217, 16.768367, 23.439295}}};
constexpr Grid<8, 9> kInnerTension = {
    {{1.121522, 1.128549, 1.212345, 1.488641, 2.111582, 3.380095, 5.823399, 9.597072, 11.956668},
     {1.121522, 1.128062, 1.207083, 1.462591, 2.011391, 3.012981, 4.540634, 6.115284, 6.781077},
     {1.121522, 1.126475, 1.190560, 1.389791, 1.771578, 2.333911, 2.954601, 3.412388, 3.574514},
     {1.121522, 1.122330, 1.160412, 1.281751, 1.493754, 1.770444, 2.062706, 2.310535, 2.418636},
     {1.121522, 1.113212, 1.112082, 1.149161, 1.232945, 1.364178, 1.540658, 1.730854, 1.825012},
     {1.121522, 1.091965, 1.033410, 0.995465, 1.002456, 1.065326, 1.187771, 1.341276, 1.421251},
     {1.121522, 1.038731, 0.909863, 0.836636, 0.822397, 0.863521, 0.960048, 1.087527, 1.155106},
     {1.121522, 0.975144, 0.820724, 0.756815, 0.749233, 0.789433, 0.879063, 0.997152, 1.059855}}};
constexpr Grid<8, 9> kInnerBending = {
    {{1.121522, 1.128549, 1.212345, 1.488641, 2.111582, 3.380095, 5.823399, 9.597072, 11.956668},
     {1.121522, 1.128031, 1.206952, 1.462212, 2.010381, 3.010460, 4.535100, 6.105269, 6.766161},
     {1.121522, 1.126014, 1.188444, 1.383553, 1.755620, 2.297759, 2.886748, 3.314070, 3.464121},
     {1.121522, 1.120070, 1.149887, 1.252029, 1.425840, 1.640431, 1.856782, 2.040599, 2.123098},
     {1.121522, 1.105866, 1.079602, 1.068701, 1.078957, 1.115319, 1.187896, 1.287076, 1.341662},
     {1.121522, 1.071044, 0.954375, 0.841516, 0.768013, 0.742931, 0.767268, 0.825873, 0.861515},
     {1.121522, 0.980239, 0.752945, 0.618643, 0.558087, 0.542156, 0.561774, 0.605577, 0.632085},
     {1.121522, 0.870357, 0.618909, 0.523985, 0.490031, 0.485443, 0.506548, 0.546756, 0.570695}}};
constexpr Grid<8, 9> kInnerTorsion = {
    {{1.000000, 1.000382, 1.005706, 1.026334, 1.075327, 1.166604, 1.309178, 1.478049, 1.564974},
     {1.000000, 1.000214, 1.005294, 1.025480, 1.073892, 1.164467, 1.306218, 1.474289, 1.560847},
     {1.000000, 0.998860, 0.999934, 1.014056, 1.054678, 1.135873, 1.266841, 1.424370, 1.505953},
     {1.000000, 0.993299, 0.979302, 0.971792, 0.986307, 1.037447, 1.134607, 1.259244, 1.325331},
     {1.000000, 0.978444, 0.929260, 0.879873, 0.851803, 0.858962, 0.908315, 0.986058, 1.029761},
     {1.000000, 0.942442, 0.831360, 0.736149, 0.678241, 0.659182, 0.677327, 0.720839, 0.747288},
     {1.000000, 0.858494, 0.679749, 0.581033, 0.535222, 0.521444, 0.533655, 0.563966, 0.582661},
     {1.000000, 0.768837, 0.582004, 0.510184, 0.482343, 0.476497, 0.489764, 0.517418, 0.534200}}};
constexpr std::array<double, 11> kPenny = {
    0,    0.0220245676671809, 0.0859423525312736, 0.185496636468387, 0.310942352531274,
    0.45, 0.589057647468726,  0.714503363531613,  0.814057647468726, 0.877975432332819,
    0.9};
constexpr Grid<3, 11> kPennyFactors = {{{0.636620, 0.636602, 0.636832, 0.638816, 0.647255, 0.671011,
                                         0.723424, 0.822647, 0.987028, 1.201410, 1.322468},
                                        {0.424413, 0.424431, 0.424443, 0.424485, 0.424958, 0.427828,
                                         0.438629, 0.467682, 0.527524, 0.616337, 0.669540},
                                        {0.424413, 0.424443, 0.424449, 0.424478, 0.424792, 0.426726,
                                         0.434122, 0.454334, 0.496541, 0.559936, 0.598214}}};
// clang-format on

/// Interpolates 1/F, which is smoother than F: it is linear in q for a thin wall and tends to zero
/// for a deep crack.
template <std::size_t N, std::size_t M>
constexpr Grid<N, M> inverse(Grid<N, M> grid) {
  for (auto& row : grid)
    for (double& value : row) value = 1 / value;
  return grid;
}

/// Weights of the rows at r_i/r_o.
std::array<double, 8> wall_weights(double radius_ratio, double lowest) {
  return lagrange(kWall, std::sqrt((1 - radius_ratio) / (1 - lowest)));
}

/// Approximate factor of a crack from a hole in an unbounded body, xi = a/(r_i + a).  It is divided
/// out before the interpolation, because it bends sharply at a depth of the hole's radius.  The
/// table corrects any error of it.
constexpr Grid<3, 5> kHole = {{{1.1215, -0.7088, -0.0012, 0.7249, -0.4998},
                               {1.1215, -1.2814, 0.456, 0.396, -0.2676},
                               {1.0, -1.3547, 1.5196, -1.0883, 0.3478}}};

constexpr double hole_factor(std::size_t load, double depth_ratio, double radius_ratio) {
  const double a = depth_ratio * (1 - radius_ratio);
  const double xi = a / (radius_ratio + a);
  return polynomial(kHole[load], xi);
}

/// hole_factor/F at the nodes.
constexpr Grid<8, 9> relative_to_hole(std::size_t load, Grid<8, 9> grid) {
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 9; ++j)
      grid[i][j] = hole_factor(load, kDepth[j], 1 - 0.9 * kWall[i] * kWall[i]) / grid[i][j];
  return grid;
}

// Coefficients of t^0, t^2, t^4, t^6 (of t, t^3, ... in sliding), for each a/d and, in it, each
// a/c. tools/reference/bar_surface.py --library.
// clang-format off
constexpr std::array<double, 2> kShallowDepth = {0.025, 0.05};
constexpr std::array<double, 5> kFrontDepth = {0.1, 0.2, 0.3, 0.4, 0.5};
constexpr std::array<double, 5> kFrontAspect = {0.0, 0.25, 0.5, 0.75, 1.0};
constexpr std::size_t kFrontTerms = 4;
using Coefficients = std::array<Grid<5, kFrontTerms>, 7>;
constexpr Coefficients kFrontTension = {{
  {{
    {1.0720, -0.4459, 0.1054, -0.4686},
    {1.0114, -0.4951, 0.1195, -0.2625},
    {0.8841, -0.3225, -0.0224, 0.1242},
    {0.7610, -0.1382, 0.0467, 0.0973},
    {0.6591, 0.0565, -0.0399, 0.1001}}},
  {{
    {1.0559, -0.3851, 0.1328, -0.4922},
    {1.0053, -0.4015, 0.1635, -0.3959},
    {0.8875, -0.2730, -0.0659, 0.1177},
    {0.7655, -0.1234, 0.0360, 0.0989},
    {0.6625, 0.0615, -0.0481, 0.1154}}},
  {{
    {1.0593, -0.3175, 0.1604, -0.4974},
    {1.0164, -0.3279, 0.2584, -0.5134},
    {0.9051, -0.1933, -0.0568, 0.0057},
    {0.7814, -0.0945, 0.0176, 0.1030},
    {0.6736, 0.0732, -0.0659, 0.1482}}},
  {{
    {1.1656, -0.2528, 0.1796, -0.4822},
    {1.1208, -0.2225, 0.1931, -0.4556},
    {1.0023, -0.1584, 0.1847, -0.2661},
    {0.8528, -0.0300, -0.0188, 0.1273},
    {0.7204, 0.1122, -0.1136, 0.2327}}},
  {{
    {1.4026, -0.2232, 0.1894, -0.4779},
    {1.3474, -0.1716, 0.1780, -0.4342},
    {1.1986, -0.0733, 0.1421, -0.2325},
    {0.9970, 0.0643, -0.0739, 0.1966},
    {0.8119, 0.1932, -0.1965, 0.3728}}},
  {{
    {1.8204, -0.2128, 0.1969, -0.4813},
    {1.7457, -0.1388, 0.1769, -0.4223},
    {1.5436, 0.0217, 0.1033, -0.1752},
    {1.2510, 0.2193, -0.1834, 0.3633},
    {0.9678, 0.3563, -0.3673, 0.6445}}},
  {{
    {2.5550, -0.2226, 0.1817, -0.4587},
    {2.4433, -0.1138, 0.1553, -0.3715},
    {2.1509, 0.1596, 0.0004, -0.0049},
    {1.7002, 0.4940, -0.4437, 0.7667},
    {1.2337, 0.6890, -0.7750, 1.2514}}}}};
constexpr Coefficients kFrontBending = {{
  {{
    {1.0383, -0.4444, 0.0969, -0.4408},
    {0.9796, -0.4648, 0.1103, -0.2585},
    {0.8554, -0.2857, -0.0387, 0.1255},
    {0.7353, -0.1073, 0.0325, 0.0993},
    {0.6358, 0.0797, -0.0452, 0.0989}}},
  {{
    {0.9885, -0.3801, 0.1119, -0.4387},
    {0.9413, -0.3628, 0.1500, -0.3769},
    {0.8298, -0.2102, -0.0879, 0.1166},
    {0.7137, -0.0655, 0.0110, 0.1016},
    {0.6157, 0.1061, -0.0577, 0.1124}}},
  {{
    {0.9228, -0.3050, 0.1193, -0.4045},
    {0.8857, -0.2793, 0.2161, -0.4471},
    {0.7874, -0.1026, -0.0771, 0.0037},
    {0.6763, 0.0061, -0.0209, 0.1037},
    {0.5790, 0.1553, -0.0817, 0.1401}}},
  {{
    {0.8698, -0.2265, 0.1140, -0.3391},
    {0.8368, -0.1682, 0.1246, -0.3349},
    {0.7473, -0.0464, 0.1279, -0.2194},
    {0.6298, 0.1158, -0.0603, 0.1126},
    {0.5236, 0.2466, -0.1299, 0.2038}}},
  {{
    {0.8911, -0.1836, 0.1096, -0.3015},
    {0.8565, -0.1162, 0.0969, -0.2814},
    {0.7611, 0.0231, 0.0840, -0.1724},
    {0.6248, 0.2055, -0.0934, 0.1451},
    {0.4946, 0.3418, -0.1906, 0.2947}}},
  {{
    {0.9860, -0.1590, 0.1086, -0.2824},
    {0.9457, -0.0858, 0.0900, -0.2534},
    {0.8357, 0.0780, 0.0536, -0.1254},
    {0.6671, 0.2979, -0.1450, 0.2226},
    {0.4944, 0.4594, -0.2903, 0.4470}}},
  {{
    {1.1876, -0.1512, 0.1028, -0.2658},
    {1.1350, -0.0684, 0.0810, -0.2240},
    {0.9994, 0.1362, 0.0034, -0.0435},
    {0.7785, 0.4179, -0.2545, 0.3927},
    {0.5342, 0.6323, -0.4918, 0.7419}}}}};
constexpr Coefficients kFrontSliding = {{
  {{
    {0.3566, -0.4359, 0.6778, -0.5352},
    {0.5115, -0.2248, 0.1953, -0.2190},
    {0.7498, -0.0969, 0.0904, -0.0867},
    {0.9436, -0.1262, -0.1870, 0.1061},
    {1.0995, -0.4983, 0.1206, -0.0101}}},
  {{
    {0.4653, -0.4898, 0.7581, -0.6134},
    {0.5584, -0.1880, 0.0488, -0.1841},
    {0.7783, -0.1528, 0.0303, -0.0180},
    {0.9468, -0.1477, -0.1654, 0.1160},
    {1.0844, -0.4778, 0.1232, -0.0032}}},
  {{
    {0.5915, -0.4658, 0.6728, -0.5623},
    {0.6392, -0.2321, 0.1690, -0.2719},
    {0.8053, -0.0477, -0.3464, 0.2091},
    {0.9531, -0.1721, -0.1422, 0.1427},
    {1.0576, -0.4383, 0.1281, 0.0122}}},
  {{
    {0.7500, -0.3673, 0.4443, -0.3652},
    {0.7543, -0.1274, 0.0038, -0.1234},
    {0.8871, -0.2486, 0.1970, -0.1740},
    {0.9701, -0.1614, -0.1655, 0.2306},
    {1.0181, -0.3581, 0.1183, 0.0636}}},
  {{
    {0.8901, -0.3281, 0.3968, -0.2594},
    {0.8707, -0.0689, -0.0393, -0.0259},
    {0.9605, -0.1352, -0.0577, 0.1001},
    {1.0037, -0.0811, -0.3040, 0.4042},
    {1.0010, -0.2530, 0.0233, 0.1904}}},
  {{
    {1.0517, -0.3282, 0.4684, -0.1983},
    {1.0091, -0.0169, -0.0557, 0.0891},
    {1.0714, -0.0300, -0.2286, 0.3269},
    {1.0639, 0.1020, -0.6821, 0.7807},
    {1.0083, -0.0652, -0.3059, 0.5122}}},
  {{
    {1.2005, -0.2445, 0.3516, 0.0508},
    {1.1300, 0.1496, -0.3478, 0.4480},
    {1.1764, 0.2485, -0.8244, 0.9147},
    {1.1204, 0.5159, -1.6463, 1.6347},
    {1.0154, 0.3492, -1.2386, 1.3126}}}}};
constexpr Coefficients kFrontTearing = {{
  {{
    {0.9263, -0.3118, -0.0567, -0.2997},
    {0.8662, -0.4568, 0.0995, -0.2191},
    {0.7375, -0.4643, -0.1641, 0.1157},
    {0.6170, -0.4763, -0.2684, 0.3697},
    {0.5207, -0.5538, 0.0227, 0.2221}}},
  {{
    {0.8772, -0.2322, -0.0574, -0.2762},
    {0.8310, -0.3445, 0.0751, -0.2238},
    {0.7140, -0.4014, -0.1881, 0.1737},
    {0.5966, -0.4487, -0.2574, 0.3592},
    {0.5018, -0.5331, 0.0143, 0.2231}}},
  {{
    {0.8058, -0.1488, -0.0330, -0.2325},
    {0.7727, -0.2470, 0.1252, -0.2537},
    {0.6710, -0.3148, -0.1065, 0.1090},
    {0.5584, -0.3956, -0.2424, 0.3453},
    {0.4654, -0.4936, -0.0025, 0.2255}}},
  {{
    {0.7103, -0.0633, 0.0040, -0.1488},
    {0.6865, -0.1336, 0.0965, -0.1544},
    {0.6004, -0.2030, -0.0122, 0.0472},
    {0.4918, -0.2991, -0.2397, 0.3459},
    {0.3985, -0.4216, -0.0399, 0.2348}}},
  {{
    {0.6515, -0.0077, -0.0011, -0.0490},
    {0.6310, -0.0678, 0.0570, -0.0427},
    {0.5497, -0.1034, -0.1211, 0.1975},
    {0.4396, -0.2158, -0.2783, 0.3891},
    {0.3406, -0.3581, -0.0930, 0.2591}}},
  {{
    {0.6217, 0.0449, -0.0722, 0.1004},
    {0.6009, -0.0160, -0.0178, 0.0975},
    {0.5211, -0.0373, -0.2046, 0.3159},
    {0.4030, -0.1391, -0.3816, 0.4957},
    {0.2916, -0.2987, -0.1843, 0.3169}}},
  {{
    {0.5902, 0.1191, -0.2712, 0.3546},
    {0.5678, 0.0501, -0.1950, 0.3197},
    {0.4950, 0.0408, -0.4045, 0.5393},
    {0.3713, -0.0483, -0.5991, 0.7049},
    {0.2467, -0.2260, -0.3622, 0.4456}}}}};
// clang-format on

/// Weights of the depths, the shallow ones first.  Shallower than the other nodes, the polynomial
/// through those gets a correction that leaves its value and slope at the first of them.
template <class Real>
std::array<Real, 7> depth_weights(const Real& x) {
  const std::array<Real, 5> deep = lagrange_products(kFrontDepth, x);
  std::array<Real, 7> weight{};
  for (std::size_t i = 0; i < 5; ++i) weight[2 + i] = deep[i];
  if (!(value_of(x) < kFrontDepth[0])) return weight;
  const std::array<Real, 2> line = lagrange_products(kShallowDepth, x);
  const Real left = x - kFrontDepth[0];
  for (std::size_t n = 0; n < 2; ++n) {
    const double whole = kShallowDepth[n] - kFrontDepth[0];
    weight[n] = line[n] * left * left / (whole * whole);
    const std::array<double, 5> there = lagrange_products(kFrontDepth, kShallowDepth[n]);
    for (std::size_t i = 0; i < 5; ++i) weight[2 + i] -= weight[n] * there[i];
  }
  return weight;
}

}  // namespace

double annular_outer_bending(double depth_ratio, double radius_ratio) {
  static constexpr auto kTable = inverse(kOuterBending);
  return 1 / interpolate(kTable, wall_weights(radius_ratio, 0.0), lagrange(kDepth, depth_ratio));
}

std::array<double, 3> annular_inner(double depth_ratio, double radius_ratio) {
  static constexpr std::array kTables = {relative_to_hole(0, kInnerTension),
                                         relative_to_hole(1, kInnerBending),
                                         relative_to_hole(2, kInnerTorsion)};
  const auto row = wall_weights(radius_ratio, 0.1);
  const auto column = lagrange(kDepth, depth_ratio);
  std::array<double, 3> factor{};
  for (std::size_t i = 0; i < 3; ++i)
    factor[i] = hole_factor(i, depth_ratio, radius_ratio) / interpolate(kTables[i], row, column);
  return factor;
}

std::array<double, 3> penny_in_bar(double x) {
  static constexpr auto kTable = inverse(kPennyFactors);
  const auto weight = lagrange(kPenny, x);
  std::array<double, 3> factor{};
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < weight.size(); ++j) sum += weight[j] * kTable[i][j];
    factor[i] = 1 / sum;
  }
  return factor;
}

template <class Real>
BasicOneSidedTable<Real>::BasicOneSidedTable(const Real& aspect) {
  static_assert(kKink == kFrontDepth[0]);
  static_assert(kDepths == kShallowDepth.size() + kFrontDepth.size() && kTerms == kFrontTerms);
  const std::array<Real, kFrontAspect.size()> weight = lagrange_products(kFrontAspect, aspect);
  const std::array<const Coefficients*, 4> tables = {&kFrontTension, &kFrontBending, &kFrontSliding,
                                                     &kFrontTearing};
  for (std::size_t load = 0; load < tables.size(); ++load)
    for (std::size_t i = 0; i < kDepths; ++i)
      for (std::size_t j = 0; j < weight.size(); ++j)
        for (std::size_t m = 0; m < kTerms; ++m)
          curves_[load][i][m] += weight[j] * (*tables[load])[i][j][m];
}

template <class Real>
BasicOneSidedFactors<Real> BasicOneSidedTable<Real>::at(const Real& depth_ratio, double t) const {
  const std::array<Real, kDepths> weight = depth_weights(depth_ratio);
  const double t2 = t * t;
  const std::array<double, kTerms> power = {1.0, t2, t2 * t2, t2 * t2 * t2};
  std::array<Real, 4> factor{};
  for (std::size_t load = 0; load < factor.size(); ++load)
    for (std::size_t i = 0; i < kDepths; ++i) {
      Real along(0.0);
      for (std::size_t m = 0; m < kTerms; ++m) along += curves_[load][i][m] * power[m];
      factor[load] += weight[i] * along;
    }
  return {.tension = factor[0],
          .bending = factor[1],
          .sliding = t * factor[2],
          .tearing = factor[3]};  // (SB-7)
}

template class BasicOneSidedTable<double>;
template class BasicOneSidedTable<CrackReal>;

OneSidedFactors one_sided_factors(double depth_ratio, double aspect, double t) {
  return BasicOneSidedTable<double>(aspect).at(depth_ratio, t);
}

}  // namespace strainwave::sif
