// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <torch/torch.h>

#include "core/shape/crisp/film_sdf.h"
#include "core/shape/sdf_mesher.h"

namespace hydrabench {

/// The distance field that a decoder and the modulation of one object stand for, made fast to ask:
/// gains and shifts are folded into the weights of the layers, as g (W x + b) + h = (g W) x + (g b
/// + h). Keeps copies; may be called from several threads at once.
/// @param modulation  [modulationSize()] or [1, modulationSize()]
SdfField makeFilmField(const FilmSdfImpl& decoder, const torch::Tensor& modulation);

}  // namespace hydrabench
