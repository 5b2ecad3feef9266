// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/types/image.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// Labels of the classes of these names; names that the label space does not have are passed over.
std::vector<Label> labelsNamed(const std::vector<std::string>& names,
                               const LabelSpace& label_space);

/// Sets the pixels that show one of the classes to 255.
/// @param mask  of the image's size
void maskClasses(const Image<Label>& image, const std::vector<Label>& classes,
                 Image<std::uint8_t>& mask);

}  // namespace hydrabench
