// A word with braces stands for several: the lines that one line of a manifest stands for.
//
//   -D TAPS={2,4} -E {a,b}    four lines; several braces multiply, in the order of the words
//   -D {FAST,}                with the macro and without: an empty word goes, and the -D before it
#pragma once

#include <string>
#include <vector>

namespace boxcar {

// One of the lines, and what tells its output from the others'.
struct Permutation {
    std::vector<std::string> words;
    std::string suffix;           // ".TAPS=2", of every word with braces but the file and the entry point
    std::string entryFromBraces;  // the entry point if it had braces, else ""
};

// Splits a line at spaces outside "" and {}; drops what follows a #. Throws UsageError for a " or { without its end.
std::vector<std::string> SplitWords(std::string_view line);

// Throws UsageError: braces without a value or with a / in a value that names an output; more than 4096 permutations.
std::vector<Permutation> Permute(const std::vector<std::string>& words);

}  // namespace boxcar
