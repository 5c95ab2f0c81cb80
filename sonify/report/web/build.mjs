// Bundles src/ and its libraries into the two files included in report.html, and collects the licences.
// `node build.mjs [folder]` writes to the folder (default: ../templates).
import { build } from 'esbuild'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'

const out = process.argv[2] ?? join(import.meta.dirname, '..', 'templates')
const manifest = JSON.parse(readFileSync(join(import.meta.dirname, 'package.json'), 'utf8'))

// `import text from 'text:package/file'` returns the text of a file, for code that runs in another thread.
const asText = {
  name: 'text',
  setup(building) {
    building.onResolve({ filter: /^text:/ }, ({ path }) => ({
      path: join(import.meta.dirname, 'node_modules', path.slice('text:'.length)),
      namespace: 'text',
    }))
    building.onLoad({ filter: /.*/, namespace: 'text' }, ({ path }) => ({
      contents: readFileSync(path, 'utf8'),
      loader: 'text',
    }))
  },
}

await build({
  absWorkingDir: import.meta.dirname,
  entryPoints: { page: 'src/main.js' },
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  legalComments: 'none',
  charset: 'ascii',
  outdir: out,
  plugins: [asText],
})

const licences = Object.keys(manifest.dependencies).map((name) => {
  const folder = join(import.meta.dirname, 'node_modules', name)
  const { version, license, author } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'))
  return `${name} ${version}, ${license}, ${author?.name ?? author ?? ''}\n${text(folder)}`
})
writeFileSync(join(out, 'page.licenses.txt'), licences.join('\n\n'))

function text(folder) {
  for (const file of ['LICENSE', 'LICENSE.txt', 'LICENSE.md']) {
    try {
      return readFileSync(join(folder, file), 'utf8').trim() + '\n'
    } catch (error) {
      if (error.code !== 'ENOENT') throw error
    }
  }
  return 'The package comes without the text of its licence.\n'
}
