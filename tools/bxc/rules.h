// What bxc refuses though the compiler accepts it. Each rule is one file in rules/: rules/NAME.cpp defines
// boxcar::rules::NAME::Check, and the build finds it by its file name. There is no list to extend.
#pragma once

#include "tools/bxc/compiler.h"
#include "tools/bxc/diagnostic.h"

namespace boxcar {

// What a rule looks at.
struct RuleInput {
    const CompiledShader& shader;
    const CompiledShader* before = nullptr;  // the vertex shader that --after names
};

// Appends an error, with its place, for everything that the rule refuses.
using RuleCheck = void(const RuleInput& input, Diagnostics& diagnostics);

// Applies every rule, in the order of their names. Each message ends in the rule's name: [binding_clash].
void CheckRules(const RuleInput& input, Diagnostics& diagnostics);

}  // namespace boxcar
