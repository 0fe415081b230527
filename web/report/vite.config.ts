import { createHash } from 'node:crypto';
import { resolve } from 'node:path';
import { defineConfig, type Plugin } from 'vite';

const out = process.env['BERM_WEB_OUT'] ?? resolve(import.meta.dirname, '../dist');

/**
 * Puts script and style into the page, so that it is one file that opens from anywhere, and allows that one script by
 * its hash: whatever a recording is called, nothing else runs, and nothing is fetched.
 */
function intoOneFile(): Plugin {
  return {
    name: 'into-one-file',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const page = Object.values(bundle).find((file) => file.fileName.endsWith('.html'));
      if (page?.type !== 'asset') return this.error('there is no page');
      let script = '';
      let style = '';
      for (const file of Object.values(bundle)) {
        if (file === page) continue;
        if (file.type === 'chunk') script += file.code.trim();
        else if (file.fileName.endsWith('.css')) style += String(file.source).trim();
        else this.error(`${file.fileName} is not part of the page`);
        delete bundle[file.fileName];
      }
      script = script.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
      const hash = createHash('sha256').update(script).digest('base64');
      const policy = `default-src 'none'; script-src 'sha256-${hash}'; style-src 'unsafe-inline'; img-src data:`;
      const html = String(page.source)
        .replace(/ *<script type="module"[^>]*><\/script>\n?/g, '')
        .replace(/ *<link rel="stylesheet"[^>]*>\n?/g, '')
        .replace(
          '</title>',
          () => `</title>\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`,
        )
        .replace('  </head>', () => `  <style>${style}</style>\n  </head>`)
        .replace('  </body>', () => `  <script type="module">${script}</script>\n  </body>`);
      page.source = html;
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [intoOneFile()],
  build: {
    outDir: out,
    emptyOutDir: false,
    sourcemap: false,
    target: 'es2022',
    modulePreload: false,
    rollupOptions: { input: resolve(import.meta.dirname, 'report.html') },
  },
});
