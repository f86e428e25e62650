// What the program says: a document on standard output, problems and progress on standard error.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace boxcar {

// Writes a document, such as a table or the help, to standard output. Throws Error where it cannot be written whole.
void PrintDocument(std::string_view text);

// The same for JSON, as UTF-8: what is none in a string, such as the name of a file, becomes \xHH (ValidUtf8).
void PrintJson(const nlohmann::ordered_json& json);

// "boxcar: TEXT" on a line of standard error, made Printable(). Where that is full there is nobody to tell.
void PrintProblem(std::string_view text);

}  // namespace boxcar
