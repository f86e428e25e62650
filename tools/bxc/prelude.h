// Text that is put in front of a shader and adds what the compiler lacks of the language. It does not count as lines,
// so messages keep the right line numbers, and it holds only what the shader uses and does not define itself.
//
//   select, and, or          with -HV 2021: HLSL 2021's, on scalars and vectors of bool, int, uint, half, float and
//                            double in every mixture that the conditional operator takes; select with a scalar
//                            condition also on float matrices. Both values are evaluated.
//   InterlockedCompareStore  in its three forms
//   Store2, Store3, Store4   of RWByteAddressBuffer, with a scalar or any vector that converts
#pragma once

#include <string>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/outline.h"
#include "tools/bxc/source.h"

namespace boxcar {

// shader  the preprocessed text
// source  the files it is made of, all read
std::string MakePrelude(const CompileOptions& options, const Outline& shader, const Source& source);

}  // namespace boxcar
