// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "worker_runtime/security/exposure.h"
#include "worker_runtime/security/local_address.h"

namespace flair::runtime {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(LocalAddress, OnlyThisMachineCanBeMeant) {
  for (const char* address :
       {"127.0.0.1:50051", "127.9.8.7:0", "[::1]:50051", "localhost:1", "LocalHost:1", "unix:/run/flair.sock", "unix:x",
        "dns:///localhost:50051", "ipv4:127.0.0.1:1", "ipv6:[::1]:1", "[::ffff:127.0.0.1]:1"}) {
    EXPECT_TRUE(IsLocalAddress(address)) << address;
  }
  for (const char* address :
       {"0.0.0.0:50051", "[::]:50051", "10.0.0.1:1", "128.0.0.1:1", "example.org:1", "localhost.example.org:1",
        "127.0.0.1.example.org:1", "127.1:1", "127.0.0.1", "", ":1", "dns:///optimizer:50053", "ipv4:0.0.0.0:1",
        "127.0.0.1:1,10.0.0.1:1", "[::ffff:10.0.0.1]:1", "vsock:2:1", "dns:///dns:///localhost:1"}) {
    EXPECT_FALSE(IsLocalAddress(address)) << address;
  }
}

config::v1::RuntimeConfig Listening(const std::string& address) {
  config::v1::RuntimeConfig runtime;
  runtime.set_listen_address(address);
  return runtime;
}

TEST(Exposure, PlainTextIsForThisMachine) {
  EXPECT_EQ(ExposureFault(Listening(""), std::nullopt), "");
  EXPECT_EQ(ExposureFault(Listening("127.0.0.1:50051"), std::nullopt), "");
  EXPECT_EQ(ExposureFault(Listening("unix:/run/x"), false), "");
  EXPECT_THAT(ExposureFault(Listening("0.0.0.0:50051"), std::nullopt),
              AllOf(HasSubstr("\"0.0.0.0:50051\""), HasSubstr("plain text"),
                    HasSubstr("runtime.tls with require_client_certificate"), HasSubstr("runtime.allow_insecure"),
                    Not(HasSubstr("tokens_path"))));
  EXPECT_THAT(ExposureFault(Listening("[::]:50050"), true), AllOf(HasSubstr("plain text"), HasSubstr("tokens_path")));
}

TEST(Exposure, WhoServesOthersAsksWhoTheyAre) {
  config::v1::RuntimeConfig runtime = Listening("0.0.0.0:50051");
  runtime.mutable_tls()->set_certificate_path("c");
  EXPECT_THAT(ExposureFault(runtime, std::nullopt), HasSubstr("anybody may call"));
  EXPECT_THAT(ExposureFault(runtime, false), AllOf(HasSubstr("anybody may call"), HasSubstr("tokens_path")));
  EXPECT_EQ(ExposureFault(runtime, true), "");
  runtime.mutable_tls()->set_require_client_certificate(true);
  EXPECT_EQ(ExposureFault(runtime, std::nullopt), "");
  EXPECT_EQ(ExposureFault(runtime, false), "");
}

TEST(Exposure, MayBeWanted) {
  config::v1::RuntimeConfig runtime = Listening("0.0.0.0:50051");
  runtime.set_metrics_address("0.0.0.0:9090");
  EXPECT_THAT(MetricsExposureFault(runtime), HasSubstr("\"0.0.0.0:9090\""));
  runtime.set_allow_insecure(true);
  EXPECT_EQ(ExposureFault(runtime, std::nullopt), "");
  EXPECT_EQ(MetricsExposureFault(runtime), "");
}

}  // namespace
}  // namespace flair::runtime
