// What bxc refuses although the compiler accepts it. Each rule is one file in rules/: rules/NAME.cpp defines
// boxcar::rules::NAME::Check, and the build finds it by its file name. There is no list to extend.
#pragma once

#include "tools/bxc/compiler.h"
#include "tools/bxc/diagnostic.h"
#include "tools/bxc/outline.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

// A shader as the rules see it.
struct RuleSubject {
    CompileOptions options;
    CompiledShader compiled;
    Outline outline;  // where things are declared
    ShaderLayout
        declared;  // all resources and variables, before the optimizer removes anything; empty without an entry point
    ShaderLayout used;  // those that the entry point uses

    // The entry point; line 1 of the file if there is none.
    SourcePlace EntryPlace() const;
};

// Appends an error with its place for each thing that the rule refuses, and the notes that belong to it.
//
//   before  the shader that --after names, or nullptr
using RuleCheck = void(const RuleSubject& shader, const RuleSubject* before, Diagnostics& diagnostics);

// Applies every rule, in the order of their names. Each error ends in the rule's name: [binding_clash].
void CheckRules(const RuleSubject& shader, const RuleSubject* before, Diagnostics& diagnostics);

}  // namespace boxcar
