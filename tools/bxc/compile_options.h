// How one shader is compiled: the flags that `bxc compile` and every line of a manifest share. One parser reads both,
// so a flag means the same everywhere. Flags are named as in fxc and dxc. Their other flags are ignored if they
// cannot change the SPIR-V, and refused with the reason if they can.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/base/error.h"
#include "tools/bxc/flags.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

struct Define {
    std::string name;
    std::string value;

    bool operator==(const Define&) const = default;
};

// -fvk-t-shift 100 0: register(tN, space0) is binding 100 + N of set 0.
struct RegisterShift {
    static constexpr int kAllSets = -1;

    char registerClass = 't';  // b, s, t, u
    int shift = 0;
    int set = kAllSets;

    bool operator==(const RegisterShift&) const = default;
};

// Paths are relative to the manifest's folder, or to the working folder for `bxc compile`.
struct CompileOptions {
    std::string file;
    ShaderStage stage = ShaderStage::Pixel;  // -T vs_5_0 or without the version: vs, hs, ds, gs, ps, cs
    std::string entry = "main";              // -E
    std::vector<Define> defines;             // -D NAME[=VALUE], in order, a name once; VALUE is 1 unless given
    std::vector<std::string> includeDirs;    // -I, in order
    int optimization = 3;                    // -O0 or -Od (legal SPIR-V, nothing more) .. -O3
    bool debugInfo = false;                  // -Zi: source text and line numbers in the SPIR-V
    bool warningsAreErrors = false;          // -WX
    bool dx9Compatible = false;              // -Gec: sampler, tex2D and the like
    int hlslVersion = 2018;                  // -HV 2016, 2017, 2018 or 2021; 2021 has select, and, or
    bool rowMajor = false;                   // -Zpr; else -Zpc: the order of matrices that do not say theirs
    bool strictMath = false;                 // -Gis: no product and sum are fused
    bool native16Bit = false;                // -enable-16bit-types: half and min16float have 16 bits
    bool invertY = false;                    // -fvk-invert-y: the position's y is negated
    bool dxPositionW = false;  // -fvk-use-dx-position-w: w of SV_Position in a pixel shader as in Direct3D
    std::vector<RegisterShift>
        shifts;  // -fvk-{b,s,t,u}-shift; with any of these, what none of them names is not shifted

    std::string after;                             // --after: the shader that feeds this one, or ""
    ShaderStage afterStage = ShaderStage::Vertex;  // --after-T; before a domain shader always hull
    std::string afterEntry = "main";               // --after-E

    std::string output;        // -o, or ""
    std::string binary;        // -Fo: the same whatever it ends in, or ""
    std::string outputSuffix;  // --outputSuffix: behind the name of an output in a manifest
    std::string header;        // -Fh: a C header to write the SPIR-V to, or ""
    std::string variable;      // -Vn: its array; g_ and the entry point unless given

    bool operator==(const CompileOptions&) const = default;
};

// The flags, which write to `options`; -T sets `hasProfile`. Both must outlive the flags.
std::vector<Flag> CompileFlags(CompileOptions& options, bool& hasProfile);

// Reads FILE and flags, on top of `defaults`. Throws UsageError: the text names the word that is wrong and what would
// be accepted.
CompileOptions ParseCompileOptions(std::span<const std::string> words, const CompileOptions& defaults = {});

// What ParseCompileOptions checks once everything is read; `others` are the words that are not flags.
void CheckCompileOptions(CompileOptions& options, bool hasProfile, std::span<const std::string> others);

// The flags that were given, in a canonical form: the same text means the same SPIR-V. Without FILE and outputs.
std::string ToText(const CompileOptions& options);

// The flags and what they mean, for HelpText.
extern const char* const kCompileFlagsHelp;

}  // namespace boxcar
