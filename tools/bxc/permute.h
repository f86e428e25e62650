// A word with braces stands for several words, so one line of a manifest stands for several lines.
//
//   -D TAPS={2,4} -E {a,b}    four lines: every combination, in the order of the words
//   -D {FAST,}                with the macro and without: an empty word is left out, and so is the -D before it
#pragma once

#include <string>
#include <vector>

namespace boxcar {

// One of the lines, and what sets its output apart from the others.
struct Permutation {
    std::vector<std::string> words;
    std::string suffix;           // ".TAPS=2", of every word with braces except for the file and the entry point
    std::string entryFromBraces;  // the entry point if it had braces, else ""
};

// Splits a line at spaces outside "" and {}; drops what follows a #. Throws UsageError for a " or { that is never
// closed.
std::vector<std::string> SplitWords(std::string_view line);

// Throws UsageError: braces without a value or with a / in a value that names an output; more than 4096 permutations.
std::vector<Permutation> Permute(const std::vector<std::string>& words);

}  // namespace boxcar
