// main() of the test programs that use a device.
#include <gtest/gtest.h>

#include "tests/support/test_device.h"

namespace {

class ValidationListener : public testing::EmptyTestEventListener {
    void OnTestEnd(const testing::TestInfo&) override {
        for (const std::string& message : boxcar::TakeValidationMessages())
            ADD_FAILURE() << "the validation layer says: " << message;
    }
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new ValidationListener);
    return RUN_ALL_TESTS();
}
