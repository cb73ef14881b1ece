// The one module of the viewer: a page starts itself, a notebook's widget is started by anywidget.

import { App } from './app';
import { h } from './dom';
import { PAYLOAD_VERSION, type Payload } from './generated';
import { Problem } from './problem';
import { isRecord } from './material';

interface WidgetModel {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  save_changes(): void;
  on(event: string, listener: () => void): void;
  off(event: string, listener: () => void): void;
}

type Rooted = HTMLElement & { motes?: App };

function begin(root: Rooted, data: unknown, host: ConstructorParameters<typeof App>[2]): App | null {
  const payload = data as Payload;
  try {
    if (!isRecord(data) || data['format'] !== 'motes view' || data['version'] !== PAYLOAD_VERSION) throw new Problem('The data of this page are of another version of Motes', 'Write it again with motes view');
    root.motes = new App(root, payload, host);
    return root.motes;
  } catch (error) {
    const [text, hint] = error instanceof Problem ? [error.message, error.hint] : [`The viewer cannot start: ${error instanceof Error ? error.message : String(error)}`, 'The pictures below stand in for it'];
    root.querySelector('.motes-why')?.remove();
    root.prepend(h('p', { class: 'motes-message failed', role: 'alert' }, `${text}. ${hint}.`));
    return null;
  }
}

/** For anywidget: `state` follows what is set, and may be set. */
function render({ model, el }: { model: WidgetModel; el: HTMLElement }): () => void {
  const root: Rooted = h('div', { class: 'motes motes-widget' });
  el.append(root);
  let own = '';
  const app = begin(root, model.get('payload'), {
    link: false,
    changed: (state) => {
      own = JSON.stringify(state);
      model.set('state', JSON.parse(own));
      model.save_changes();
    },
  });
  const given = (): void => {
    const state = model.get('state');
    if (app && isRecord(state) && JSON.stringify(state) !== own) app.apply(state);
  };
  model.on('change:state', given);
  return () => {
    model.off('change:state', given);
    app?.dispose();
  };
}

const data = document.getElementById('motes-data');
const page = document.getElementById('motes');
if (data && page) begin(page, JSON.parse(data.textContent ?? 'null'), { link: true });

export default { render };
