// Reads what glslang prints.
#pragma once

#include <string>

#include "tools/bxc/diagnostic.h"
#include "tools/bxc/source.h"

namespace boxcar {

// Appends the messages of a log to `diagnostics`, each once. `mainFile` is the place of those that name none. Columns
// are looked up in `source`, because glslang 12 does not print them:
//   ERROR: file:line: 'token' : message
//   WARNING: message
//   file(line): error at column N, HLSL parsing failed.
// Warnings of attributes that mean nothing to Vulkan, such as RootSignature, are left out.
void AppendGlslangLog(const std::string& log, const std::string& mainFile, const Source& source,
                      Diagnostics& diagnostics);

}  // namespace boxcar
