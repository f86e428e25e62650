// What bxc is asked to do: its command line, and the flags of one shader, which the command line and every line of a
// manifest share. One parser reads both, so a flag means the same everywhere.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/layout/error.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

struct Define {
    std::string name;
    std::string value;

    bool operator==(const Define&) const = default;
};

// How one shader is compiled. Paths are relative to the manifest's folder, or to the working folder for `bxc
// compile`.
struct CompileOptions {
    std::string file;
    ShaderStage stage = ShaderStage::Pixel;  // -T vs_5_0, ps_5_0, cs_5_0 or without the version: vs, ps, cs
    std::string entry = "main";              // -E
    std::vector<Define> defines;             // -D NAME[=VALUE], in order; VALUE is 1 unless given
    std::vector<std::string> includeDirs;    // -I, in order
    int optimization = 3;                    // -O0 (legal SPIR-V, nothing more) .. -O3
    bool debugInfo = false;                  // -Zi: source text and line numbers in the SPIR-V
    bool warningsAreErrors = false;          // -WX
    bool dx9Compatible = false;              // -Gec: sampler, tex2D and the like
    int hlslVersion = 2018;  // -HV 2016, 2017, 2018 or 2021: taken from lines shared with dxc; no effect
    std::string after;       // --after: the vertex shader that feeds this pixel shader, or ""
    std::string output;      // -o, or ""

    bool operator==(const CompileOptions&) const = default;
};

// Reads FILE and flags, in the form `-T ps_5_0` or `/T ps_5_0`; -D and -I also take their value without a space.
// Throws UsageError: the text names the word that is wrong and what would be accepted.
CompileOptions ParseCompileOptions(std::span<const std::string> words);

// The flags that were given, in a canonical form: the same text compiles the same. Without FILE and -o.
std::string ToText(const CompileOptions& options);

enum class Command { Compile, Build, Worker, Help, Version };

struct Options {
    Command command = Command::Help;
    CompileOptions compile;   // of `compile`
    std::string manifest;     // of `build`, as are the next four
    std::string outputDir;    // -o
    int jobs = 0;             // -j: worker processes, 1..256; 0 is one a core
    std::string embed;        // --embed NAME: a C++ identifier, or ""
    std::string depfile;      // --depfile FILE, or ""
    int timeoutSeconds = 60;  // --timeout: of one shader, 1..86400
    int maxMemoryMib = 1024;  // --max-memory: resident size of one worker, 64..1048576
    std::string help;         // of `help`: the text to print
};

// `words` is argv without the program's name. Throws UsageError.
Options ParseOptions(std::span<const std::string> words);

}  // namespace boxcar
