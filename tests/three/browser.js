// Headless Chromium with a page that can reach nothing but the files of a test.
'use strict';

const fs = require('fs');
const path = require('path');

const k_patience_ms = 300000; // for a browser that starts on a busy machine

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

/// Ends the test where Chromium or the modules are missing.
function needBrowser(moduleFolder, chromium, names) {
  for (const name of [...names, 'playwright-core']) {
    if (!fs.existsSync(path.join(moduleFolder, 'node_modules', name, 'package.json'))) {
      skip(`npm's ${name} is not in ${moduleFolder}; install it with: npm ci --prefix ${moduleFolder} (after copying tests/three/package*.json there)`);
    }
  }
  if (!fs.existsSync(chromium)) skip('Chromium is not installed; install it with: apt-get install chromium');
}

/// Opens page.html with a script of this folder; `folders`: what it reaches below /NAME/. Calls `use(page)`.
async function withPage(moduleFolder, chromium, script, folders, use) {
  const modules = path.join(moduleFolder, 'node_modules');
  const all = { three: path.join(modules, 'three'), vrm: path.join(modules, '@pixiv', 'three-vrm'),
                'vrm-animation': path.join(modules, '@pixiv', 'three-vrm-animation'), ...folders };
  const types = { '.js': 'text/javascript', '.html': 'text/html', '.png': 'image/png', '.jpg': 'image/jpeg', '.json': 'application/json' };
  const browser = await require(path.join(modules, 'playwright-core')).chromium.launch({
    executablePath: chromium,
    timeout: k_patience_ms,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
           '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(k_patience_ms);
    await page.route('**/*', (route) => {
      const { hostname, pathname } = new URL(route.request().url());
      const [, first, ...rest] = decodeURIComponent(pathname).split('/');
      const file = all[first] ? path.join(all[first], ...rest) : path.join(__dirname, first, ...rest);
      if (hostname !== 'localhost' || !fs.existsSync(file)) return route.abort();
      return route.fulfill({ body: fs.readFileSync(file), contentType: types[path.extname(file)] || 'application/octet-stream' });
    });
    page.on('pageerror', (error) => console.log(`in the page: ${error.message}`));
    page.on('console', (message) => { if (message.type() === 'error') console.log(`in the page: ${message.text()}`); });
    await page.goto(`http://localhost/page.html?${script}`);
    await page.waitForFunction(() => window.ready);
    await use(page);
  } finally {
    await browser.close();
  }
}

module.exports = { needBrowser, withPage };
