// Compiled shaders as C++, so that a program carries them with it.
//
//   #include "NAME.h"
//   const boxcar::EmbeddedShader& shader = boxcar::NAME::Find("sat_pass.ps.TAPS=4");
//   for (const boxcar::EmbeddedShader& each : boxcar::NAME::All()) ..
#pragma once

#include <string>
#include <vector>

#include "tools/bxc/manifest.h"

namespace boxcar {

// Writes DIR/NAME.h and DIR/NAME.cpp from the outputs of `jobs`, which must exist. A file that would not change is
// not touched. Throws Error naming the file that cannot be read or written.
void WriteEmbedded(const std::vector<ShaderJob>& jobs, const std::string& dir, const std::string& name);

}  // namespace boxcar
