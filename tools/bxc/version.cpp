#include "tools/bxc/version.h"

namespace boxcar {

const char* Version() {
    return BOXCAR_VERSION;
}

}  // namespace boxcar
