// SPDX-License-Identifier: GPL-3.0-or-later
// flair mcp before the official TypeScript clients: the one of the revisions with a handshake, and, where Node is new enough for
// it, that of revision 2026-07-28. Usage: node mcp.mjs FLAIR FOLDER; FOLDER is empty.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { Client } from '@modelcontextprotocol/sdk/client/index.js';
import { StdioClientTransport } from '@modelcontextprotocol/sdk/client/stdio.js';
import { ErrorCode } from '@modelcontextprotocol/sdk/types.js';

const [flair, folder] = process.argv.slice(2);
const root = join(folder, 'root');
mkdirSync(root);
mkdirSync(join(folder, 'outside'));
const server = {
  command: flair,
  args: ['mcp', '--root', root],
  env: { ...process.env, FLAIR_HOME: join(folder, 'home') },
  stderr: 'pipe',
};

async function connect() {
  const client = new Client({ name: 'flair-tests', version: '1' });
  client.onerror = (error) => assert.fail(`the client could not read a message: ${error}`);
  await client.connect(new StdioClientTransport(server));
  // Listing gives the client the output schemas, which it checks every result against.
  const { tools } = await client.listTools();
  return { client, tools };
}

const call = async (client, name, args, options) => {
  const result = await client.callTool({ name, arguments: args }, undefined, options);
  assert.ok(!result.isError, `${name}: ${result.content[0]?.text}`);
  return result;
};
const fault = async (client, name, args) => {
  const result = await client.callTool({ name, arguments: args });
  assert.equal(result.isError, true, `${name} should fail`);
  return result.content[0].text;
};

let room;
let lastRevision;

test('a room is designed with progress, edited, explained, drawn and written', async () => {
  const { client, tools } = await connect();
  assert.equal(client.getServerVersion().name, 'flair');
  assert.match(client.getInstructions(), /south-west corner/);
  assert.ok(tools.length >= 22);

  const told = [];
  const designed = await call(client, 'design', { brief: 'A bedroom that is 4m x 5m, with a grand piano.', seed: 7 },
    { onprogress: (progress) => told.push(progress) });
  room = designed.structuredContent;
  assert.deepEqual(JSON.parse(designed.content[0].text), room);
  assert.ok(told.some(({ message }) => /^objects: /.test(message)));
  told.forEach(({ progress, total }, i) => assert.ok(progress <= total && (i === 0 || progress > told[i - 1].progress)));
  assert.equal(told.at(-1).progress, told.at(-1).total);
  const bed = room.objects.find(({ id }) => id === 'double_bed');
  assert.ok(bed && bed.x_m > 0 && bed.x_m < 4);
  assert.equal(room.room.openings.some(({ kind }) => kind === 'door'), true);
  const document_id = room.document_id;

  const { structuredContent: { documents } } = await call(client, 'list_documents', {});
  assert.equal(documents[0].document_id, document_id);
  assert.equal(documents[0].state, 'ready');

  const wardrobe = room.objects.find(({ name }) => name === 'wardrobe');
  const to = { x_m: wardrobe.x_m + 0.3, y_m: wardrobe.y_m };
  const moved = (await call(client, 'move', { document_id, object: 'the wardrobe', ...to })).structuredContent;
  const now = moved.moved.find(({ id }) => id === wardrobe.id);
  assert.ok(Math.abs(now.x_m - to.x_m) < 0.002, `asked for ${to.x_m}, got ${now.x_m}`);
  assert.equal(moved.done, 'move the wardrobe');

  const lamp = (await call(client, 'add', { document_id, furniture: 'floor lamp', near: 'double_bed' })).structuredContent;
  assert.ok(lamp.moved.some(({ id }) => id === 'floor_lamp'));
  await call(client, 'resize', { document_id, object: 'floor_lamp', height_m: 1.8 });
  await call(client, 'pin', { document_id, object: 'floor_lamp' });
  const pinned = (await call(client, 'describe', { document_id })).structuredContent;
  assert.equal(pinned.objects.find(({ id }) => id === 'floor_lamp').pinned, true);
  await call(client, 'unpin', { document_id, object: 'floor_lamp' });
  await call(client, 'replace', { document_id, object: 'floor_lamp', furniture: 'armchair' });
  const gone = (await call(client, 'remove', { document_id, object: 'floor_lamp' })).structuredContent;
  assert.deepEqual(gone.removed, ['floor_lamp']);

  await call(client, 'say', { document_id, sentence: 'The wardrobe is against the west wall.' });
  const why = (await call(client, 'explain', { document_id, object: 'wardrobe' })).structuredContent;
  const said = why.note.demands.find(({ sentence }) => sentence === 'The wardrobe is against the west wall.');
  assert.ok(said, JSON.stringify(why.note));
  await call(client, 'weigh', { document_id, sentence_id: said.sentence_id, weight: 3 });
  await call(client, 'drop', { document_id, sentence_id: said.sentence_id });
  const whole = await call(client, 'explain', { document_id });
  assert.match(whole.content[0].text, /double bed/);

  const loose = (await call(client, 'move', { document_id, object: wardrobe.id, x_m: 2, y_m: 2.5, heading_deg: 90, settle: false })).structuredContent;
  assert.ok(loose.moved.every(({ id, stands_on }) => id === wardrobe.id || stands_on));
  await call(client, 'settle', { document_id });
  assert.match(await fault(client, 'redo', { document_id }), /nothing to do again/);

  const before = (await call(client, 'describe', { document_id })).structuredContent;
  const found = (await call(client, 'alternatives', { document_id, count: 2 })).structuredContent;
  assert.ok(found.alternatives.length > 0);
  await call(client, 'take_alternative', { document_id, index: 0 });
  await call(client, 'undo', { document_id });
  await call(client, 'redo', { document_id });
  await call(client, 'undo', { document_id });
  const after = (await call(client, 'describe', { document_id })).structuredContent;
  assert.deepEqual(after.objects, before.objects);

  for (const view of ['plan', 'birdseye']) {
    const drawn = await call(client, 'render', { document_id, view, size_px: view === 'plan' ? 2048 : 256 });
    const image = drawn.content.find(({ type }) => type === 'image');
    const bytes = Buffer.from(image.data, 'base64');
    assert.equal(image.mimeType, 'image/png');
    assert.deepEqual([...bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.ok(image.data.length < 1_000_000);
    assert.equal(Math.max(bytes.readUInt32BE(16), bytes.readUInt32BE(20)), drawn.structuredContent.size_px);
  }

  const written = (await call(client, 'export', { document_id, format: 'layout_json', path: 'rooms/bedroom.json' })).structuredContent;
  assert.equal(written.path, join(root, 'rooms/bedroom.json'));
  JSON.parse(readFileSync(written.path, 'utf8'));
  await call(client, 'export', { document_id, format: 'layout_json', path: written.path });
  for (const format of ['plan_png', 'plan_svg', 'plan_pdf', 'scene_glb', 'layout_pb', 'artifacts_tar']) {
    await call(client, 'export', { document_id, format });
    await call(client, 'export', { document_id, format });
  }
  writeFileSync(join(root, 'mine.md'), 'flair of mine');
  assert.match(await fault(client, 'export', { document_id, format: 'report_md', path: 'mine.md' }), /not Flair's/);
  await call(client, 'export', { document_id, format: 'report_md', path: 'mine.md', overwrite: true });
  symlinkSync(join(folder, 'outside'), join(root, 'link'));
  for (const path of ['../outside/x.json', join(folder, 'outside/x.json'), 'link/x.json', '/etc/flair.json']) {
    await fault(client, 'export', { document_id, format: 'layout_json', path, overwrite: true });
    assert.equal(existsSync(join(folder, 'outside/x.json')), false);
  }

  const { resources } = await client.listResources();
  const layout = resources.find(({ uri }) => uri === `flair://document/${document_id}/layout.json`);
  const { contents: [read] } = await client.readResource({ uri: layout.uri });
  const artifact = JSON.parse(read.text);
  const { contents: [same] } = await client.readResource({ uri: `flair://artifact/${artifact.id}` });
  assert.deepEqual(JSON.parse(same.text), artifact);
  const { contents: [plan] } = await client.readResource({ uri: `flair://document/${document_id}/plan.png` });
  assert.equal(Buffer.from(plan.blob, 'base64').subarray(1, 4).toString(), 'PNG');
  const { resourceTemplates } = await client.listResourceTemplates();
  assert.ok(resourceTemplates.some(({ uriTemplate }) => uriTemplate === 'flair://artifact/{artifact_id}'));
  await assert.rejects(client.readResource({ uri: 'flair://document/none/layout.json' }), /no document/);
  await assert.rejects(client.readResource({ uri: 'file:///etc/passwd' }), /no resource/);

  const { structuredContent: { job_id } } = await call(client, 'share', { document_id });
  assert.equal((await call(client, 'share', { document_id })).structuredContent.job_id, job_id);

  const { structuredContent: { furniture } } = await call(client, 'find_furniture', { words: 'lamp', limit: 3 });
  assert.equal(furniture.length, 3);
  lastRevision = after.revision;
  await client.close();
});

test('faults are told: of tools as results, of the protocol as errors', async () => {
  const { client } = await connect();
  const document_id = room.document_id;
  // Another process goes on with the room.
  const { structuredContent: same } = await call(client, 'describe', { document_id });
  assert.equal(same.revision, lastRevision);
  assert.match(await fault(client, 'move', { document_id, object: 'throne', x_m: 1, y_m: 1 }), /no piece of the room.*double_bed/);
  assert.match(await fault(client, 'move', { document_id, object: 'double_bed', x_m: 'left', y_m: 1 }), /x_m: "left"; must be a number/);
  assert.match(await fault(client, 'describe', { document_id: 'none' }), /no document/);
  assert.match(await fault(client, 'undo', { document_id, revision: 1 }), /somebody else has changed it/);
  assert.match(await fault(client, 'say', { document_id, sentence: 'Green ideas sleep furiously.' }), /not understood/);
  assert.match(await fault(client, 'add', { document_id, furniture: 'flux capacitor' }), /not in the catalogue/);
  assert.match(await fault(client, 'design', { brief: '' }), /brief: ""/);
  await assert.rejects(client.callTool({ name: 'sing', arguments: {} }), { code: ErrorCode.InvalidParams });
  await assert.rejects(client.listPrompts(), /prompts/);
  await client.close();
});

test('a cancelled design ends and leaves nothing', async () => {
  const { client } = await connect();
  const before = (await call(client, 'list_documents', {})).structuredContent.documents.length;
  const stop = new AbortController();
  await assert.rejects(
    client.callTool({ name: 'design', arguments: { brief: 'A very large office that is 20m x 20m with thirty desks.' } },
      undefined, { signal: stop.signal, onprogress: () => stop.abort('enough') }));
  // The document goes when the design has ended; each look is an answer of the server's.
  let left;
  do left = (await call(client, 'list_documents', {})).structuredContent.documents.length; while (left > before);
  assert.equal(left, before);
  await client.close();
});

// Without a client: what stands on standard output, byte by byte, and how the program ends.
async function talk(lines, { end = true, signal } = {}) {
  const child = spawn(server.command, server.args, { env: server.env });
  let out = '';
  let err = '';
  child.stdout.setEncoding('utf8').on('data', (text) => {
    out += text;
    if (signal && out.includes('\n')) child.kill(signal);
  });
  child.stderr.setEncoding('utf8').on('data', (text) => (err += text));
  child.stdin.write(lines.map((line) => `${line}\n`).join(''));
  if (end) child.stdin.end();
  const [code] = await once(child, 'close');
  return { code, err, messages: out.split('\n').slice(0, -1).map((line) => JSON.parse(line)) };
}
const hello = JSON.stringify({
  jsonrpc: '2.0', id: 0, method: 'initialize',
  params: { protocolVersion: '2025-06-18', capabilities: {}, clientInfo: { name: 't', version: '1' } },
});

test('the end of the input ends the program, also while a design runs', async () => {
  const { code, messages } = await talk([hello, '{', '[]', JSON.stringify({
    jsonrpc: '2.0', id: 1, method: 'tools/call', params: { name: 'design', arguments: { brief: 'An office that is 20m x 20m with thirty desks.' } } })]);
  assert.equal(code, 0);
  assert.deepEqual(messages.map(({ id, error }) => error?.code ?? id), [0, -32700, -32600]);
  assert.equal(messages[0].result.protocolVersion, '2025-06-18');
});

test('SIGTERM ends the program', async () => {
  const { code, messages } = await talk([hello], { end: false, signal: 'SIGTERM' });
  assert.equal(code, 0);
  assert.equal(messages.length, 1);
});

test('a folder that is not there is refused before anything is said', async () => {
  const child = spawn(flair, ['mcp', '--root', join(folder, 'nowhere')], { env: server.env });
  let out = '';
  let err = '';
  child.stdout.on('data', (text) => (out += text));
  child.stderr.on('data', (text) => (err += text));
  const [code] = await once(child, 'close');
  assert.equal(out, '');
  assert.match(err, /^flair: --root: .*nowhere/);
  assert.equal(code, 4);
});

const modern = Number(process.versions.node.split('.')[0]) >= 20;
test('revision 2026-07-28 is spoken without a handshake', { skip: !modern && 'its client needs Node 20' }, async () => {
  const v2 = await import('@modelcontextprotocol/client');
  const { StdioClientTransport: Transport } = await import('@modelcontextprotocol/client/stdio');
  const client = new v2.Client({ name: 'flair-tests', version: '2' }, { versionNegotiation: { mode: { pin: '2026-07-28' } } });
  await client.connect(new Transport(server));
  assert.equal(client.getNegotiatedProtocolVersion(), '2026-07-28');
  const { tools } = await client.listTools();
  assert.ok(tools.length >= 22);
  const described = await client.callTool({ name: 'describe', arguments: { document_id: room.document_id } });
  assert.equal(described.structuredContent.document_id, room.document_id);
  await assert.rejects(client.readResource({ uri: 'flair://document/none/layout.json' }), /no document/);
  await client.close();
});
