// What bxc has to say about a user's shader, as values. The report prints them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace boxcar {

enum class Severity { Note, Warning, Error };  // a note belongs to the message before it

// A place in a source text. line and column count from 1; 0 is unknown.
struct SourcePlace {
    std::string file;
    int line = 0;
    int column = 0;

    bool operator==(const SourcePlace&) const = default;
};

struct Diagnostic {
    SourcePlace place;
    Severity severity = Severity::Error;
    std::string text;

    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

bool HasErrors(const Diagnostics& diagnostics);

// The form that gcc prints and editors jump to: "shaders/sat.ps.hlsl:12:5: error: text", leaving out
// numbers that are unknown.
std::string ToText(const Diagnostic& diagnostic);

}  // namespace boxcar
