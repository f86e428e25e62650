// From HLSL to SPIR-V. One interface, so that another compiler can stand behind it; today glslang does.
//
// Bindings: register(bN) is binding N, sN is 16 + N, uN is 32 + N, tN is 96 + N, spaceN is set N. A resource without
// a register gets the next free binding of its class.
#pragma once

#include "tools/bxc/diagnostic.h"
#include "tools/bxc/options.h"
#include "tools/bxc/source.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace boxcar {

// A resource that the HLSL declares.
struct DeclaredResource {
    std::string name;
    uint32_t set = 0;
    uint32_t binding = 0;
    uint32_t count = 1;  // array length; 0 for an array without a length
    bool used = false;   // by the entry point or what it calls
    SourcePlace place;   // of the declaration
};

// One location, or one built-in, of a stage interface.
struct DeclaredVariable {
    std::string name;      // the parameter's or the field's; "" for the value that the entry point returns
    std::string semantic;  // upper case, with its index: "TEXCOORD1", "SV_POSITION"
    std::string type;      // "float4"
    bool builtIn = false;  // then it has no location
    uint32_t location = 0;
    SourcePlace place;
};

// Something of which only the name and the place matter.
struct DeclaredName {
    std::string name;
    SourcePlace place;
};

// What the compiler made of one entry point, and what the rules need to know of its source.
struct CompiledShader {
    std::string file = {};
    std::string entry = {};
    ShaderStage stage = ShaderStage::Pixel;
    std::vector<uint32_t> spirv = {};  // neither legalised nor valid for Vulkan yet; empty if there were errors
    bool hasEntry = false;
    SourcePlace entryPlace = {};                  // line 1 of the file if there is none
    std::vector<DeclaredName> looseGlobals = {};  // constants outside a cbuffer
    std::vector<DeclaredResource> resources = {};
    std::vector<DeclaredVariable> inputs = {};
    std::vector<DeclaredVariable> outputs = {};
};

class Compiler {
public:
    virtual ~Compiler() = default;

    // Appends what the compiler says to `diagnostics`, each message once; if it refuses the shader, at least one of
    // them is an error. Reads its files from `source`.
    virtual CompiledShader Compile(const CompileOptions& options, Source& source, Diagnostics& diagnostics) = 0;
};

// Name and version of the compiler, for --version and for the record of what made an output.
std::string CompilerVersion();

std::unique_ptr<Compiler> MakeCompiler();

}  // namespace boxcar
