// The list of shaders that `bxc build` compiles.
//
//   # file, relative to the manifest, then flags as fxc and dxc take them
//   shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS={2,4,8,16}
//
// A value in braces makes one shader of each of its values; several of them multiply. Words with spaces go in "".
// The output is named after the file without .hlsl, the entry point if it is not main, and the values in braces:
// DIR/shaders/sat_pass.ps.TAPS=4.spv. #include looks in the manifest's own folder last.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/bxc/diagnostic.h"
#include "tools/bxc/options.h"

namespace boxcar {

// One shader to compile and where its outputs go.
struct ShaderJob {
    std::string root;        // folder of the manifest, to which the paths in `options` are relative; "" for none
    CompileOptions options;  // `output` is the shader's name: "sat_pass.ps.TAPS=4", from which its files are named
    std::string output;      // the .spv file, beside which the others go: DIR/sat_pass.ps.TAPS=4.spv

    bool operator==(const ShaderJob&) const = default;
};

// The shaders in `text`, in order. Errors are appended to `diagnostics`, each with its line: a flag or a value that
// is not accepted, an output that another line writes too, an output that would leave `outputDir`.
std::vector<ShaderJob> ParseManifest(std::string_view text, const std::string& manifestFile,
                                     const std::string& outputDir, Diagnostics& diagnostics);

// The same for a file. Throws Error if it cannot be read.
std::vector<ShaderJob> ReadManifest(const std::string& manifestFile, const std::string& outputDir,
                                    Diagnostics& diagnostics);

}  // namespace boxcar
