// Text from outside, such as the name of a file, made fit for a terminal and for JSON. A name on Unix is any bytes.
#pragma once

#include <string>
#include <string_view>

namespace boxcar {

// `text` as one line that does nothing to a terminal: line breaks and tabs become \n, \r and \t; other control
// characters, those that turn the direction of writing, and bytes that are not UTF-8 become \xHH, a byte each. All
// else stays, the backslash too: a result that is put through it again does not change.
std::string Printable(std::string_view text);

// `text` as UTF-8, for JSON, which has its own escapes for the rest: bytes that are not UTF-8 become \xHH.
std::string ValidUtf8(std::string_view text);

}  // namespace boxcar
