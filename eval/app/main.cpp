// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/app/app.h"

int main(int argc, char** argv) { return hydrabench::runApp(argc, argv); }
