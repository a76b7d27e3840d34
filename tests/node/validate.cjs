// What the Khronos validator says of GLB files: errors and warnings, as JSON.
const { readFileSync } = require("fs");
const { validateBytes } = require("gltf-validator");

async function validated(path) {
  const { issues } = await validateBytes(new Uint8Array(readFileSync(path)));
  const messages = issues.messages.filter((one) => one.severity < 2);
  return { path, errors: issues.numErrors, warnings: issues.numWarnings, messages };
}

Promise.all(process.argv.slice(2).map(validated)).then((told) => console.log(JSON.stringify(told)));
