// Public names whose comments say too little, read off the published declarations as an editor shows them: node docs/comments.mjs [file.d.ts …]
import ts from 'typescript';
import { exportsOf, isHidden, modules, parse } from './declarations.mjs';

/**
 * A name without a comment, one whose comment says nothing but the name, and an option that does not say what leaving it out
 * means. Overloads and a getter with its setter are one; members that override take the comment of what they override.
 * @returns {{ checked: number, poor: string[] }}
 */
function poorComments(files) {
  const program = parse(files);
  const checker = program.getTypeChecker();
  const seen = new Set();
  const poor = [];
  for (const symbol of exportsOf(program, files)) {
    visit(symbol, symbol.name);
  }
  return { checked: seen.size, poor: poor.sort() };

  function visit(symbol, path) {
    const declared = (symbol.declarations ?? []).filter(
      (node) => !program.isSourceFileDefaultLibrary(node.getSourceFile()),
    );
    const [first] = declared;
    if (!first || seen.has(first) || isHidden(first)) {
      return;
    }
    seen.add(first);
    const reason = fault(symbol, declared);
    if (reason !== '') {
      poor.push(`${path} ${reason}`);
    }
    for (const member of declared.flatMap((node) => membersOf(node, symbol))) {
      visit(member, `${path}.${member.name}`);
    }
  }

  /** Of a class or an interface, inherited ones too, and of object types written out. What stands for an object of the browser is documented there. */
  function membersOf(node, symbol) {
    if (/ContextLike$/.test(symbol.name)) {
      return [];
    }
    if (ts.isClassDeclaration(node) || ts.isInterfaceDeclaration(node)) {
      const statics = [...(symbol.exports?.values() ?? [])];
      return [...statics, ...checker.getPropertiesOfType(checker.getDeclaredTypeOfSymbol(symbol))];
    }
    return writtenOut(node);
  }

  /** Tags count as well: `@returns` says something. */
  function fault(symbol, declared) {
    const text = ts.displayPartsToString(symbol.getDocumentationComment(checker));
    const tags = symbol.getJsDocTags(checker).map((tag) => ts.displayPartsToString(tag.text));
    const words = [text, ...tags].join(' ').match(/[\p{L}\p{N}°]+/gu) ?? [];
    if (words.length === 0) {
      return 'has no comment';
    }
    const name = symbol.name.toLowerCase();
    if (words.every((word) => name.includes(word.toLowerCase()) || /^(?:a|an|the|of|get|set)s?$/i.test(word))) {
      return 'has a comment that says nothing but the name';
    }
    const option = declared.some((node) => node.questionToken && /Params|Options/.test(node.parent.name?.text ?? ''));
    return option && !/default|without|left out|omitted/i.test(words.join(' ')) ? 'does not say its default' : '';
  }
}

function writtenOut(node) {
  const found = ts.isTypeLiteralNode(node) ? node.members.flatMap(({ symbol }) => symbol ?? []) : [];
  ts.forEachChild(node, (child) => {
    found.push(...writtenOut(child));
  });
  return found;
}

const files = process.argv.slice(2);
console.log(JSON.stringify(poorComments(files.length > 0 ? files : modules), null, 1));
