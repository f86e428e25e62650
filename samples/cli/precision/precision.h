// boxcar precision: how well tables of several precisions, biases, origins and builders give a picture back.
#pragma once

#include "samples/cli/options.h"
#include "samples/cli/precision/measure.h"

namespace boxcar {

// Whole codes: those of a file of 8 or 16 bits that is taken raw; its linear light is rounded to 16 bits; float
// pictures have none.
Subject SubjectOf(const Picture& picture, Transfer transfer);

}  // namespace boxcar
