// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Compiled by the tests named layers.*, which pass only if this does not compile: the first include
// is found, the second is not.
#include "core/types/ids.h"
#include "eval/datasets/dataset.h"
