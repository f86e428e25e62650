#include "samples/files/bytes.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tools/base/descriptor.h"
#include "tools/base/error.h"
#include "tools/base/output_file.h"
#include "tools/base/read_file.h"

namespace boxcar {

std::string InputName(const std::string& path) {
    return path == "-" ? "standard input" : path;
}
std::string OutputName(const std::string& path) {
    return path == "-" ? "standard output" : path;
}

Bytes ReadBytes(const std::string& path, uint64_t maxBytes, const std::function<void(ByteView)>& checkStart) {
    const ReadFileOptions options{InputName(path), maxBytes, checkStart};
    return path == "-" ? ReadDescriptor(STDIN_FILENO, options) : ReadFile(path, options);
}

bool IsStandardOutput(const std::string& path) {
    return path == "-" || DescriptorOf(path) == STDOUT_FILENO;
}

void WriteFileAtomically(const std::string& path, ByteView bytes) {
    OutputFile file(path, std::as_bytes(bytes));
    const bool isWritten =
        path == "-" ? WriteAll(STDOUT_FILENO, std::as_bytes(bytes)) : file.Prepare() && file.Commit();
    if (!isWritten) throw Error("{}: cannot be written: {}", OutputName(path), std::strerror(errno));
}

}  // namespace boxcar
