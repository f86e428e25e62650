// Reads the two texts that glslang prints: its log, and preprocessed source.
#pragma once

#include "tools/bxc/diagnostic.h"
#include "tools/bxc/source.h"

#include <map>
#include <string>

namespace boxcar {

// Appends the messages of a log to `diagnostics`, each once. `mainFile` is the place of those that name none. Columns
// are looked up in `source`, because glslang 12 does not print them:
//   ERROR: file:line: 'token' : message
//   WARNING: message
//   file(line): error at column N, HLSL parsing failed.
void AppendGlslangLog(const std::string& log, const std::string& mainFile, const Source& source,
                      Diagnostics& diagnostics);

// Where each name first stands outside brackets in preprocessed source that starts in line 1 of `mainFile`. For a
// global variable this is its declaration, which glslang's tree does not hold.
std::map<std::string, SourcePlace> PlacesOfGlobals(const std::string& preprocessed, const std::string& mainFile,
                                                   const Source& source);

}  // namespace boxcar
