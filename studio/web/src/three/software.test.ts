// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { isSoftwareName } from "./software";

test("drivers that draw without a graphics card are told by their names", () => {
  const swift = "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)";
  for (const name of [swift, "llvmpipe (LLVM 15.0.6, 256 bits)", "Microsoft Basic Render Driver"]) {
    assert.ok(isSoftwareName(name), name);
  }
  for (const name of ["ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2))", "Apple M2"]) {
    assert.ok(!isSoftwareName(name), name);
  }
});
