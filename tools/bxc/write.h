// Files out: all the files of a shader or none of them. Also decides whether they need to be written at all.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "tools/bxc/compile.h"
#include "tools/bxc/manifest.h"

namespace boxcar {

// OUT.spv, OUT.layout.json and OUT.d of an output named OUT.spv, and the header of -Fh; "" for each one that is not
// to be written. A device such as /dev/stdout gets the SPIR-V only. Where there is no .spv, the others are named
// after the header.
struct OutputFiles {
    std::string spirv;
    std::string header;
    std::string layout;
    std::string depfile;
};
OutputFiles FilesOf(const ShaderJob& job);

// The time by the clock that stamps files.
struct FileTime {
    long long nanoseconds = 0;
};
FileTime Now();

// True if all the shader's files are there and were made by this program with the same flags, and nothing that they
// depend on has changed since.
bool IsUpToDate(const ShaderJob& job);

// Writes the files under temporary names, then gives them their own: they are complete or unchanged. The depfile is
// stamped with `started`, the time before anything was read, so that a file that was edited meanwhile counts as
// changed. Throws Error naming the file that cannot be written.
void WriteOutputs(const ShaderJob& job, const CompileResult& result, FileTime started);

// Removes the files of a shader that failed, so that nobody takes old ones for new.
void RemoveOutputs(const ShaderJob& job);

// The names of the files that an up-to-date shader depends on, as in its depfile.
std::set<std::string> DependenciesOf(const ShaderJob& job);

// A file in make's format: `target` depends on `dependencies`. `comment` is its first line if it is not empty.
std::string DepfileText(const std::string& comment, const std::string& target,
                        const std::set<std::string>& dependencies);

// Writes `bytes` under a temporary name, then renames. Creates folders. Throws Error.
void WriteFile(const std::string& path, std::string_view bytes);

// The same, but leaves a file that already has these bytes untouched.
void WriteFileIfChanged(const std::string& path, std::string_view bytes);

}  // namespace boxcar
