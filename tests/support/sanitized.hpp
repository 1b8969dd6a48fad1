// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Whether a sanitizer watches the tests.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define STRAINWAVE_SANITIZED true
#elif defined(__has_feature)
#define STRAINWAVE_SANITIZED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define STRAINWAVE_SANITIZED false
#endif

namespace strainwave::test {

/// The sanitizers take ten times as long and look for other faults than numbers, so a test of many
/// alike cases takes fewer of them.  The release build takes all.
inline constexpr bool kSanitized = STRAINWAVE_SANITIZED;

}  // namespace strainwave::test
