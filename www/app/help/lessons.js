/**
 * The lessons: an index that is always there, texts and documents that are loaded when one is opened.
 */
import index from '../../lessons/index.json';

const texts = /** @type {Record<string, () => Promise<string>>} */ (import.meta.glob('../../lessons/*.html', { query: '?raw', import: 'default' }));
const documents = /** @type {Record<string, () => Promise<string>>} */ (
  import.meta.glob(['../../lessons/*.json', '!../../lessons/index.json'], { query: '?raw', import: 'default' })
);

/** @type {{id: string, title: string, line: string}[]} */
export const lessons = index;

/** @type {{close: () => void} | null} */
let open = null;

/**
 * Opens a lesson with its linkage.
 * @param {import('../../element/workbench.js').AppWithPanels} app
 * @param {string} id
 */
export async function openLesson(app, id) {
  const lesson = lessons.find((candidate) => candidate.id === id);
  if (!lesson) {
    app.say(`There is no lesson “${id}”. There are: ${lessons.map((known) => known.id).join(', ')}.`);
    return;
  }
  const [{ showLesson }, text, doc] = await Promise.all([
    import('./lesson.js'),
    texts[`../../lessons/${id}.html`](),
    documents[`../../lessons/${id}.json`](),
  ]);
  open?.close();
  await app.open(doc);
  open = showLesson(app, { ...lesson, text, doc });
}

/** The lesson that the page's address asks for. */
export const askedLesson = () => new URLSearchParams(location.search).get('lesson');
