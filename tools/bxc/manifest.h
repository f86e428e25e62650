// The list of shaders that `bxc build` compiles.
//
//   # file, relative to the manifest, then flags as fxc and dxc take them
//   shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS={2,4,8,16}
//
// A word with braces makes one shader for each of the values in them (permute.h). Words with spaces go in "".
// The output is named after the file without .hlsl, the entry point if it is not main, and the values in braces:
// DIR/shaders/sat_pass.ps.TAPS=4.spv. #include looks in the manifest's own folder last.
//
// The manifests of ShaderMake are read as they are: // starts a comment; -o FOLDER/, or an -o that several lines
// share, puts the output there under the file's bare name; #ifdef NAME, #if 0, #if 1, #else, #endif leave lines out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/bxc/compile_options.h"
#include "tools/bxc/diagnostic.h"

namespace boxcar {

// One shader to compile and where its outputs go.
struct ShaderJob {
    std::string root;        // folder of the manifest, to which the paths in `options` are relative; "" for none
    CompileOptions options;  // `output` is the shader's name: "sat_pass.ps.TAPS=4", from which its files are named
    std::string output;      // the .spv file, beside which the others go: DIR/sat_pass.ps.TAPS=4.spv

    bool operator==(const ShaderJob&) const = default;
};

// The shaders in `text`, in order, each with the flags of its line on top of `defaults`, whose macros are also what
// #ifdef knows. Errors are appended to `diagnostics`, each with its line: a flag or a value that
// is not accepted, an output that another line writes too, an output that would leave `outputDir`.
std::vector<ShaderJob> ParseManifest(std::string_view text, const std::string& manifestFile,
                                     const std::string& outputDir, const CompileOptions& defaults,
                                     Diagnostics& diagnostics);

// The same for a file; the include folders of `defaults` are relative to the working folder. Throws Error if it
// cannot be read.
std::vector<ShaderJob> ReadManifest(const std::string& manifestFile, const std::string& outputDir,
                                    const CompileOptions& defaults, Diagnostics& diagnostics);

}  // namespace boxcar
