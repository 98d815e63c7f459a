// A substitute for the gateway that serves the page with the control clock's code.
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { fileURLToPath } from 'node:url';

const html = readFileSync(fileURLToPath(new URL('../dist/vlc.html', import.meta.url)));

/** A gateway whose control clock is the counter of this process plus a large offset. */
export class ClockGateway {
  aheadNs = 1_700_000_000_000_000_000n;
  isSynchronised = true;
  token = null;
  refused = 0;
  accepted = 0;

  now = () => process.hrtime.bigint() + this.aheadNs;

  async start(port = 0) {
    this.server = createServer((request, response) => this.answer(request, response));
    this.server.listen(port, '127.0.0.1');
    await once(this.server, 'listening');
    this.port = this.server.address().port;
    return `http://127.0.0.1:${this.port}/vlc`;
  }

  answer(request, response) {
    const t2 = this.now();
    if (request.url === '/vlc') return response.setHeader('Content-Type', 'text/html').end(html);
    if (request.method !== 'POST' || request.url !== '/vlc/time') return response.writeHead(404).end();
    if (this.token && request.headers.authorization !== `Bearer ${this.token}`) {
      this.refused++;
      return response.writeHead(401).end();
    }
    this.accepted++;
    const facts = { resolution_ns: 1, is_synchronised: this.isSynchronised };
    response.end(JSON.stringify({ ...facts, t2_ns: `${t2}`, t3_ns: `${this.now()}` }));
  }

  stop() {
    this.server?.close();
    this.server?.closeAllConnections();
    this.server = null;
  }
}
