/**
 * Opens lessons: their texts and documents are loaded when one is opened.
 */
import { showLesson } from './lesson.js';
import lessons from '../../lessons/index.json';

const texts = /** @type {Record<string, () => Promise<string>>} */ (import.meta.glob('../../lessons/*.html', { query: '?raw', import: 'default' }));
const documents = /** @type {Record<string, () => Promise<string>>} */ (
  import.meta.glob(['../../lessons/*.json', '!../../lessons/index.json'], { query: '?raw', import: 'default' })
);

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
  const [text, doc] = await Promise.all([
    texts[`../../lessons/${id}.html`](),
    documents[`../../lessons/${id}.json`](),
  ]);
  open?.close();
  await app.open(doc);
  open = showLesson(app, { ...lesson, text, doc });
}
