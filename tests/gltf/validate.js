/* validate.js FILE.glb... -- what the Khronos validator says; exit 1 where it finds an error or a warning. */
const fs = require("fs");
const validator = require("gltf-validator");

async function main(files) {
  let failures = 0;
  for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    const issues = report.issues;
    console.log(`${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ` +
      `${report.info.totalTriangleCount} triangles`);
    for (const message of issues.messages) {
      console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
    }
    failures += issues.numErrors + issues.numWarnings;
  }
  process.exit(failures > 0 ? 1 : 0);
}

main(process.argv.slice(2));
