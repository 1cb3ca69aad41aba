/**
 * The applet needs all pieces of its element at once: they come with its own script.
 */
import { createPanels } from '../element/panels.js';
import { pieces } from '../element/pieces.js';
import { createWorkbench } from '../element/workbench.js';

pieces.workbench = async () => ({ createWorkbench });
pieces.panels = async () => ({ createPanels });
