// SPDX-License-Identifier: MIT
// Precompiled headers belong to a target with a source; the tests use those of this one.
