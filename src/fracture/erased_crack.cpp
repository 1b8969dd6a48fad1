// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/erased_crack.hpp"

namespace strainwave {

template <std::size_t N>
CrackCompliance<N> compliance_of(const ErasedCrack<N>& crack, const CrackModuli& moduli) {
  return added_compliance(crack, moduli);
}
template CrackCompliance<1> compliance_of(const ErasedCrack<1>&, const CrackModuli&);
template CrackCompliance<2> compliance_of(const ErasedCrack<2>&, const CrackModuli&);
template CrackCompliance<3> compliance_of(const ErasedCrack<3>&, const CrackModuli&);
template CrackCompliance<4> compliance_of(const ErasedCrack<4>&, const CrackModuli&);

}  // namespace strainwave
