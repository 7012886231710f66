import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

/** With slashes, as the compiler names files. */
const dist = join(dirname(fileURLToPath(import.meta.url)), '../dist').replaceAll('\\', '/');
/** What is imported by name, as it is published. */
export const modules = ['index', 'debug/index', 'outline/index', 'runner', 'state/index', 'audit/index'].map((name) =>
  join(dist, `${name}.d.ts`),
);

const HIDING = new Set([ts.SyntaxKind.PrivateKeyword, ts.SyntaxKind.ProtectedKeyword]);

export function parse(files) {
  return ts.createProgram(files, { target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.NodeNext, types: [] });
}

/** What modules export, by what it is where it is declared. */
export function exportsOf(program, files) {
  const checker = program.getTypeChecker();
  return files
    .flatMap((file) => checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file))))
    .map((symbol) => declaredAs(checker, symbol));
}

function declaredAs(checker, symbol) {
  return symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
}

export function isHidden({ modifiers = [], kind }) {
  return kind === ts.SyntaxKind.Constructor || modifiers.some((modifier) => HIDING.has(modifier.kind));
}

/**
 * The declarations of all public names, and of what they are declared by, such as the classes that they extend: those are not marked `export`. Without what
 * files export for each other alone, and private members.
 */
export function publicDeclarations() {
  const program = parse(modules);
  const checker = program.getTypeChecker();
  const exported = new Set(exportsOf(program, modules).flatMap(statementsOf));
  const wanted = new Set(exported);
  for (const statement of wanted) {
    for (const symbol of namesIn(statement)) {
      statementsOf(symbol).forEach((each) => void wanted.add(each));
    }
  }
  const isListed = (statement) => wanted.has(statement) || (ts.isExportDeclaration(statement) && listsNames(statement));
  return program
    .getSourceFiles()
    .map((file) => ({ file, name: relative(dist, file.fileName), statements: file.statements.filter(isListed) }))
    .filter(({ statements }) => statements.length > 0)
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .map(({ file, name, statements }) => `// ${name}\n${[headOf(file), ...statements.map(textOf)].join('').trim()}\n`)
    .join('\n');

  function namesIn(node) {
    const own = ts.isIdentifier(node) ? [checker.getSymbolAtLocation(node)].filter(Boolean) : [];
    const parts = [];
    ts.forEachChild(node, (child) => void (isHidden(child) || parts.push(...namesIn(child))));
    return [...own.map((symbol) => declaredAs(checker, symbol)), ...parts];
  }

  /** With its comment, without hidden members. */
  function textOf(statement) {
    const start = statement.getFullStart();
    let text = statement.getFullText();
    for (const member of [...(statement.members ?? [])].filter(isHidden).reverse()) {
      text = text.slice(0, member.getFullStart() - start) + text.slice(member.getEnd() - start);
    }
    return exported.has(statement) || ts.isExportDeclaration(statement)
      ? text
      : text.replace(/^export (?=declare|type|interface)/m, '');
  }
}

/** Those of the package at the top of a file that declare a name. */
function statementsOf(symbol) {
  return (symbol.declarations ?? []).flatMap((node) => {
    let statement = node;
    while (statement.parent && !ts.isSourceFile(statement.parent)) {
      statement = statement.parent;
    }
    return !ts.isSourceFile(statement) && statement.getSourceFile().fileName.startsWith(dist) ? statement : [];
  });
}

/** What a file says of its module, if that is before an import, which is left out. */
function headOf({ text, statements: [first] }) {
  return ts.isImportDeclaration(first) ? (/^\/\*\*[\s\S]*?@module[\s\S]*?\*\/\n/.exec(text)?.[0] ?? '') : '';
}

function listsNames({ exportClause }) {
  return exportClause !== undefined && exportClause.elements.length > 0;
}
