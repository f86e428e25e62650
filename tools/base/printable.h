// Makes text from outside, such as the name of a file, fit for a terminal and for JSON. On Unix a name can be any
// bytes.
#pragma once

#include <string>
#include <string_view>

namespace boxcar {

// `text` as one line that does nothing to a terminal: line breaks and tabs become \n, \r and \t; other control
// characters, those that change the direction of writing, and bytes that are not UTF-8 become \xHH, one per byte.
// Everything else stays, even the backslash, so a second call does not change the result.
std::string Printable(std::string_view text);

// `text` as UTF-8, for JSON, which has its own escapes for the rest: bytes that are not UTF-8 become \xHH.
std::string ValidUtf8(std::string_view text);

}  // namespace boxcar
