// node validate.mjs FILE...
// Prints each error and each warning of the Khronos validator, and exits with 1 if there is one.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

let found = 0;
for (const file of process.argv.slice(2)) {
    const bytes = new Uint8Array(readFileSync(file));
    const report = await validator.validateBytes(bytes, { uri: file, maxIssues: 100 });
    for (const issue of report.issues.messages) {
        if (issue.severity > 1) continue;  // 0: error, 1: warning
        console.log(`${file}: ${issue.severity === 0 ? "error" : "warning"}: ${issue.code} at ${issue.pointer ?? issue.offset}: ${issue.message}`);
        found++;
    }
}
process.exitCode = found > 0 ? 1 : 0;
