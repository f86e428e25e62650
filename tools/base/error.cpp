#include "tools/base/error.h"

#include <cstdio>
#include <cstdlib>

namespace boxcar {

void AssertFailed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, condition);
    std::abort();
}

}  // namespace boxcar
