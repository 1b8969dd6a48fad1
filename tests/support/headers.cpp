// SPDX-License-Identifier: Apache-2.0
// Nothing: its target holds the precompiled headers of the tests.
int main() { return 0; }
