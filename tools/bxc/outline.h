// Where things are declared, read from the preprocessed text, because SPIR-V does not say it.
//
// Non-goals: a parser. Tokens and brackets are enough to find a name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/bxc/source.h"

namespace boxcar {

class Outline {
public:
    // preprocessed  without comments and inactive lines, with #line where file or line jump; starts in line 1 of
    //               `mainFile`
    // source        the texts as they are in the files, for the columns. Outlives the outline.
    Outline(std::string preprocessed, const std::string& mainFile, const Source& source);

    // Where a global variable or a cbuffer is declared: its first mention outside brackets.
    SourcePlace Global(std::string_view name) const;

    // A function with a body, if there is one.
    std::optional<SourcePlace> Function(std::string_view name) const;

    // Every place where a name appears.
    struct Mention {
        bool isMethod = false;     // behind a dot
        size_t argumentCount = 0;  // of a call, as a macro of that name would count them; 0: not a call, or none
    };
    std::vector<Mention> Mentions(std::string_view name) const;

    // What the function takes: a parameter, or a field of a struct that is one. What it returns: a field of the
    // struct that it returns, an out parameter, or the function itself for "". An index is passed over: "uv[3]".
    SourcePlace Input(std::string_view function, std::string_view name) const;
    SourcePlace Output(std::string_view function, std::string_view name) const;

    // All of these return line 1 of the main file for a name that is not found.

private:
    struct Token {
        size_t begin, length;  // in m_text
        size_t file;           // in m_files
        int line;
        int depth;  // of the brackets around it
    };

    void ReadLine(size_t begin, size_t end, int line);
    std::string_view Text(size_t index) const;  // "" behind the last token
    SourcePlace PlaceOf(size_t index) const;
    size_t ClosingOf(size_t opening) const;
    size_t ArgumentCount(size_t opening) const;
    size_t FindFunction(std::string_view name) const;
    size_t FindVariable(std::string_view name, size_t owner, size_t opening) const;
    size_t FindField(std::string_view name, std::string_view structName, size_t before) const;

    const Source* m_source;
    std::string m_text;
    std::vector<std::string> m_files;  // the main file, then every one that a #line names
    std::vector<Token> m_tokens;
};

}  // namespace boxcar
