// The texts that one shader is made of: its file and the files it includes, each read once. The shader depends on
// exactly the files that were read.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/bxc/diagnostic.h"

namespace boxcar {

// Files are named relative to `root`, so the output does not depend on where that folder is.
class Source {
public:
    // root         folder of the manifest; "" for the working folder
    // includeDirs  where #include looks after the folder of the including file, in this order; relative to root. The
    //              root itself comes last.
    Source(std::string root, std::vector<std::string> includeDirs);

    struct File {
        std::string name;  // relative to root, without "." and ".."
        std::string text;
    };

    // The file of this name. nullptr: it cannot be read, is longer than 16 MiB or is not text; `error` says which.
    const File* Open(std::string_view name, std::string& error);

    // What #include "header" in the file `includer` means; `depth` counts the includes that are open. nullptr as in
    // Open, and where nothing is found or depth is over 64.
    const File* Include(std::string_view header, std::string_view includer, size_t depth, std::string& error);

    // Line `line` (from 1) of a file that was read; "" where there is none.
    std::string_view Line(std::string_view name, int line) const;

    // That line, with the column at which `word` first stands in it as a whole word, if it does.
    SourcePlace PlaceOf(std::string_view name, int line, std::string_view word) const;

    // True if a file that was read has the line `#define NAME ..`, even in a part that is not compiled.
    bool DefinesMacro(std::string_view name) const;

    // The files read so far, in the order of the first read.
    const std::vector<std::string>& Names() const { return m_names; }

private:
    std::string m_root;
    std::vector<std::string> m_includeDirs;
    std::map<std::string, File, std::less<>> m_files;
    std::vector<std::string> m_names;
};

// A letter, a digit or _.
bool IsWordChar(char c);

}  // namespace boxcar
