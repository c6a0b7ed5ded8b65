// Writes small glTF files, each broken in one way, into the folder that is named:
//     node broken_gltf.js FOLDER
// The file's name says what is wrong with it.

'use strict';
const fs = require('fs');
const path = require('path');

const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0];
const png =
    'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==';

function binary({vertices = positions, indices = [0, 1, 2]} = {}) {
  const bytes = Buffer.alloc(44);
  vertices.forEach((x, i) => bytes.writeFloatLE(x, 4 * i));
  indices.forEach((x, i) => bytes.writeUInt16LE(x, 36 + 2 * i));
  return bytes;
}

const dataUri = (bytes) => 'data:application/octet-stream;base64,' + bytes.toString('base64');

// A triangle with a material and a texture: nothing is wrong with it.
function good(numbers) {
  const bytes = binary(numbers);
  return {
    asset: {version: '2.0'},
    scene: 0,
    scenes: [{nodes: [0]}],
    nodes: [{mesh: 0}],
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}],
    materials: [{pbrMetallicRoughness: {baseColorFactor: [1, 0.5, 0, 1]}}],
    accessors: [
      {bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0]},
      {bufferView: 1, componentType: 5123, count: 3, type: 'SCALAR'},
    ],
    bufferViews: [
      {buffer: 0, byteOffset: 0, byteLength: 36, target: 34962},
      {buffer: 0, byteOffset: 36, byteLength: 6, target: 34963},
    ],
    buffers: [{byteLength: bytes.length, uri: dataUri(bytes)}],
  };
}

const primitive = (d) => d.meshes[0].primitives[0];
const material = (d) => d.materials[0];
function textured(d, use = {index: 0}) {
  d.images = [{uri: 'data:image/png;base64,' + png}];
  d.textures = [{source: 0}];
  material(d).emissiveTexture = use;
}
function extra(d, type, componentType, count, view) {
  d.accessors.push({bufferView: view, componentType, count, type});
  return d.accessors.length - 1;
}
function sparse(d, indices, values = [0, 0, 1, 0, 0, 2]) {
  const bytes = Buffer.concat([binary(), Buffer.alloc(28)]);
  indices.forEach((x, i) => bytes.writeUInt8(x, 44 + i));
  values.forEach((x, i) => bytes.writeFloatLE(x, 48 + 4 * i));
  d.buffers = [{byteLength: bytes.length, uri: dataUri(bytes)}];
  d.bufferViews.push({buffer: 0, byteOffset: 44, byteLength: 2}, {buffer: 0, byteOffset: 48, byteLength: 24});
  d.accessors[0].sparse = {count: 2, indices: {bufferView: 2, componentType: 5121}, values: {bufferView: 3}};
  delete d.accessors[0].min;
  delete d.accessors[0].max;
}

// Each changes the good document, or returns another text.
const broken = {
  good: () => {},
  asset_missing: (d) => { delete d.asset; },
  asset_version_1: (d) => { d.asset.version = '1.0'; },
  asset_version_3: (d) => { d.asset.version = '3.0'; },
  asset_version_number: (d) => { d.asset.version = 2.0; },
  asset_min_version: (d) => { d.asset.minVersion = '2.1'; },
  extension_required_unknown: (d) => { d.extensionsUsed = d.extensionsRequired = ['KHR_nonsense']; },
  extension_required_unlisted: (d) => { d.extensionsRequired = ['KHR_materials_unlit']; },
  json_truncated: (d) => JSON.stringify(d).slice(0, -1),
  json_nan: (d) => JSON.stringify(d).replace('0.5', 'NaN'),
  json_1e400: (d) => JSON.stringify(d).replace('0.5', '1e400'),
  json_duplicate_key: (d) => JSON.stringify(d).replace('{"asset"', '{"scene":0,"asset"'),
  json_array: () => '[]',
  nodes_null: (d) => { d.nodes = null; },
  node_cycle: (d) => { d.nodes = [{mesh: 0, children: [1]}, {children: [0]}]; },
  node_self: (d) => { d.nodes[0].children = [0]; },
  node_two_parents: (d) => { d.nodes = [{children: [2]}, {children: [2]}, {mesh: 0}]; d.scenes[0].nodes = [0, 1]; },
  node_child_twice: (d) => { d.nodes = [{children: [1, 1]}, {mesh: 0}]; },
  node_child_missing: (d) => { d.nodes[0].children = [7]; },
  node_mesh_missing: (d) => { d.nodes[0].mesh = 3; },
  node_matrix_short: (d) => { d.nodes[0].matrix = [1, 0, 0, 0]; },
  node_matrix_and_scale: (d) => {
    d.nodes[0].matrix = [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    d.nodes[0].scale = [1, 1, 1];
  },
  node_matrix_singular: (d) => { d.nodes[0].matrix = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]; },
  node_matrix_sheared: (d) => { d.nodes[0].matrix = [1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]; },
  node_rotation_zero: (d) => { d.nodes[0].rotation = [0, 0, 0, 0]; },
  node_rotation_long: (d) => { d.nodes[0].rotation = [0, 0, 0, 2]; },
  node_translation_text: (d) => { d.nodes[0].translation = ['a', 0, 0]; },
  scene_missing: (d) => { d.scene = 4; },
  scene_node_missing: (d) => { d.scenes[0].nodes = [9]; },
  scene_node_twice: (d) => { d.scenes[0].nodes = [0, 0]; },
  scene_node_not_root: (d) => { d.nodes = [{children: [1]}, {mesh: 0}]; d.scenes[0].nodes = [1]; },
  mesh_no_primitives: (d) => { delete d.meshes[0].primitives; },
  mesh_empty_primitives: (d) => { d.meshes[0].primitives = []; },
  primitive_no_position: (d) => { primitive(d).attributes = {}; },
  primitive_position_scalar: (d) => { primitive(d).attributes.POSITION = 1; },
  primitive_position_missing: (d) => { primitive(d).attributes.POSITION = 8; },
  primitive_indices_floats: (d) => { primitive(d).indices = 0; },
  primitive_indices_missing: (d) => { primitive(d).indices = 8; },
  primitive_indices_count: (d) => { d.accessors[1].count = 2; },
  primitive_mode: (d) => { primitive(d).mode = 9; },
  primitive_material_missing: (d) => { primitive(d).material = 5; },
  primitive_counts_differ: (d) => { primitive(d).attributes.NORMAL = extra(d, 'VEC3', 5126, 2, 0); },
  primitive_unknown_attribute: (d) => { primitive(d).attributes.COLOUR = 0; },
  primitive_normal_zero: (d) => { primitive(d).attributes.NORMAL = extra(d, 'VEC3', 5126, 3, 0); },
  primitive_texcoord_bytes: (d) => { primitive(d).attributes.TEXCOORD_0 = extra(d, 'VEC2', 5121, 3, 0); },
  primitive_color_floats_short: (d) => { primitive(d).attributes.COLOR_0 = extra(d, 'VEC2', 5126, 3, 0); },
  index_beyond_vertices: () => JSON.stringify(good({indices: [0, 1, 3]})),
  index_restart: () => JSON.stringify(good({indices: [0, 1, 65535]})),
  position_nan: () => JSON.stringify(good({vertices: [0, 0, 0, 1, NaN, 0, 0, 1, 0]})),
  position_infinite: () => JSON.stringify(good({vertices: [0, 0, 0, 1, Infinity, 0, 0, 1, 0]})),
  position_beyond_bounds: () => JSON.stringify(good({vertices: [0, 0, 0, 2, 0, 0, 0, 1, 0]})),
  position_no_bounds: (d) => { delete d.accessors[0].min; },
  accessor_count_0: (d) => { d.accessors[0].count = 0; },
  accessor_count_negative: (d) => { d.accessors[0].count = -1; },
  accessor_count_huge: (d) => { d.accessors[0].count = 4294967296; },
  accessor_count_fraction: (d) => { d.accessors[0].count = 2.5; },
  accessor_component_type: (d) => { d.accessors[0].componentType = 5124; },
  accessor_type: (d) => { d.accessors[0].type = 'VEC5'; },
  accessor_offset_unaligned: (d) => { d.accessors[0].byteOffset = 2; },
  accessor_beyond_view: (d) => { d.accessors[0].byteOffset = 4; },
  accessor_view_missing: (d) => { d.accessors[0].bufferView = 6; },
  accessor_normalized_float: (d) => { d.accessors[0].normalized = true; },
  sparse_order: (d) => { sparse(d, [2, 1]); },
  sparse_range: (d) => { sparse(d, [1, 3]); },
  sparse_count: (d) => { sparse(d, [0, 1]); d.accessors[0].sparse.count = 4; },
  sparse_component_type: (d) => { sparse(d, [0, 1]); d.accessors[0].sparse.indices.componentType = 5126; },
  sparse_value_nan: (d) => { sparse(d, [0, 1], [NaN, 0, 0, 1, 1, 1]); },
  view_beyond_buffer: (d) => { d.bufferViews[1].byteLength = 100; },
  view_offset_huge: (d) => { d.bufferViews[1].byteOffset = 9007199254740991; },
  view_offset_negative: (d) => { d.bufferViews[0].byteOffset = -4; },
  view_buffer_missing: (d) => { d.bufferViews[0].buffer = 2; },
  view_stride_5: (d) => { d.bufferViews[0].byteStride = 5; },
  view_stride_8: (d) => { d.bufferViews[0].byteStride = 8; },
  view_stride_256: (d) => { d.bufferViews[0].byteStride = 256; },
  view_length_0: (d) => { d.bufferViews[1].byteLength = 0; },
  buffer_length_0: (d) => { d.buffers[0].byteLength = 0; },
  buffer_length_long: (d) => { d.buffers[0].byteLength = 100; },
  buffer_length_short: (d) => { d.buffers[0].byteLength = 42; },
  buffer_base64: (d) => { d.buffers[0].uri += '*'; },
  buffer_missing_file: (d) => { d.buffers[0].uri = 'gone.bin'; },
  buffer_outside: (d) => { d.buffers[0].uri = '../gone.bin'; },
  buffer_no_uri: (d) => { delete d.buffers[0].uri; },
  image_missing_file: (d) => { textured(d); d.images[0].uri = 'gone.png'; },
  image_not_png: (d) => { textured(d); d.images[0].uri = 'data:image/png;base64,AAAA'; },
  image_truncated: (d) => { textured(d); d.images[0].uri = d.images[0].uri.slice(0, 60); },
  image_neither: (d) => { textured(d); d.images[0] = {}; },
  image_both: (d) => { textured(d); d.images[0].bufferView = 0; d.images[0].mimeType = 'image/png'; },
  image_view_missing: (d) => { textured(d); d.images[0] = {bufferView: 9, mimeType: 'image/png'}; },
  texture_source_missing: (d) => { textured(d); d.textures[0].source = 3; },
  texture_sampler_missing: (d) => { textured(d); d.textures[0].sampler = 3; },
  texture_index_missing: (d) => { textured(d, {index: 4}); },
  texture_no_uv: (d) => { textured(d); },
  sampler_wrap: (d) => { textured(d); d.samplers = [{wrapS: 1}]; d.textures[0].sampler = 0; },
  sampler_filter: (d) => { textured(d); d.samplers = [{magFilter: 1}]; d.textures[0].sampler = 0; },
  material_factor_short: (d) => { material(d).pbrMetallicRoughness.baseColorFactor = [1, 1, 1]; },
  material_factor_high: (d) => { material(d).pbrMetallicRoughness.baseColorFactor = [2, 1, 1, 1]; },
  material_metallic_high: (d) => { material(d).pbrMetallicRoughness.metallicFactor = 1.5; },
  material_emissive_high: (d) => { material(d).emissiveFactor = [2, 0, 0]; },
  material_emissive_short: (d) => { material(d).emissiveFactor = [1, 0]; },
  material_alpha_mode: (d) => { material(d).alphaMode = 'SHINY'; },
  material_alpha_cutoff: (d) => { material(d).alphaMode = 'MASK'; material(d).alphaCutoff = -1; },
  material_double_sided: (d) => { material(d).doubleSided = 1; },
  material_ior_low: (d) => {
    d.extensionsUsed = ['KHR_materials_ior'];
    material(d).extensions = {KHR_materials_ior: {ior: 0.5}};
  },
  material_transmission_high: (d) => {
    d.extensionsUsed = ['KHR_materials_transmission'];
    material(d).extensions = {KHR_materials_transmission: {transmissionFactor: 2}};
  },
  material_volume_distance: (d) => {
    d.extensionsUsed = ['KHR_materials_volume', 'KHR_materials_transmission'];
    material(d).extensions = {KHR_materials_transmission: {}, KHR_materials_volume: {attenuationDistance: -1}};
  },
};

function glb(json, bin, {version = 2, more = 0, jsonType = 'JSON', binClaim = 0, twice = false} = {}) {
  const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
  const header = (size, type) => {
    const bytes = Buffer.alloc(8);
    bytes.writeUInt32LE(size, 0);
    bytes.write(type, 4, 'latin1');
    return bytes;
  };
  const chunk = Buffer.concat([header(bin.length + binClaim, 'BIN\0'), bin]);
  const chunks = Buffer.concat([header(text.length, jsonType), text, chunk, twice ? chunk : Buffer.alloc(0)]);
  const start = Buffer.alloc(12);
  start.write('glTF', 0, 'latin1');
  start.writeUInt32LE(version, 4);
  start.writeUInt32LE(12 + chunks.length + more, 8);
  return Buffer.concat([start, chunks]);
}

function brokenGlbs() {
  const document = good();
  delete document.buffers[0].uri;
  const json = JSON.stringify(document);
  const whole = glb(json, binary());
  return {
    glb_good: whole,
    glb_empty: Buffer.alloc(0),
    glb_header_only: whole.subarray(0, 12),
    glb_truncated: whole.subarray(0, whole.length - 4),
    glb_version_1: glb(json, binary(), {version: 1}),
    glb_version_3: glb(json, binary(), {version: 3}),
    glb_length_long: glb(json, binary(), {more: 4}),
    glb_length_short: glb(json, binary(), {more: -4}),
    glb_first_not_json: glb(json, binary(), {jsonType: 'BIN\0'}),
    glb_second_json: glb(json, binary(), {twice: true}),
    glb_chunk_long: glb(json, binary(), {binClaim: 400}),
    glb_bin_short: glb(json, binary().subarray(0, 40)),
    glb_not_utf8: glb(json.replace('2.0"', '2.0","copyright":"\u00ff"'), binary()),
  };
}

const folder = process.argv[2];
fs.mkdirSync(folder, {recursive: true});
for (const [name, damage] of Object.entries(broken)) {
  const document = good();
  fs.writeFileSync(path.join(folder, name + '.gltf'), damage(document) || JSON.stringify(document));
}
for (const [name, bytes] of Object.entries(brokenGlbs())) {
  fs.writeFileSync(path.join(folder, name + '.glb'), bytes);
}
