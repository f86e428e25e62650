// A compiled shader as a C header, in the form that fxc and dxc write with -Fh.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "tools/bxc/compile_options.h"

namespace boxcar {

// const unsigned char g_main[] = {0x03, 0x02, ..}: the words in the byte order of this machine, aligned as words.
// The array is named by -Vn, or g_ and the entry point.
std::string CHeader(std::span<const uint32_t> spirv, const CompileOptions& options);

}  // namespace boxcar
