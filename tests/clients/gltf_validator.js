// What the Khronos validator says of each file, a line each: the file, a comma, and "ok" or the codes of its
// errors. Those of animations, cameras and skins are left out: restframe reads an asset's rest pose.
//     NODE_PATH=FOLDER node gltf_validator.js FILE...

'use strict';
const fs = require('fs');
const path = require('path');
const validator = require('gltf-validator');

const leftOut = /^\/(animations|cameras|skins)\b/;

// The files that an asset names, from its own folder.
function readBeside(file) {
  return async (uri) => new Uint8Array(
      fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri))));
}

async function verdict(file) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
    uri: path.basename(file),
    maxIssues: 0,
    externalResourceFunction: readBeside(file),
  });
  const errors = report.issues.messages.filter(
      (issue) => issue.severity === 0 && !leftOut.test(issue.pointer || ''));
  return errors.length === 0 ? 'ok' : [...new Set(errors.map((issue) => issue.code))].sort().join(' ');
}

async function main() {
  for (const file of process.argv.slice(2)) {
    // It throws where a file is not even begun as JSON or GLB.
    console.log(file + ',' + await verdict(file).catch(() => 'NOT_GLTF'));
  }
}

main();
