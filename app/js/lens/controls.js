// What moves the lens: native sliders, switches and buttons. They show a state and report a wish; they keep nothing.
/** @import { Effect, Model, Places, Preset, State, Told, Wish } from '../types.js' */
import { actionColour, short } from '../draw/drawing.js';
import { element } from '../draw/elements.js';
import { SWITCHES, available } from '../core/maths.js';

/**
 * Places that are evenly spaced in the logarithm. Values have two digits, or three where two would lead back to the
 * same place: a key that moves nothing is a key that is stuck.
 * @param {number} low
 * @param {number} high
 * @param {number} [perDecade]
 * @returns {Places}
 */
const logarithmic = (low, high, perDecade = 40) => {
  const count = Math.round(perDecade * Math.log10(high / low));
  const of = (value) => Math.round((count * Math.log10(Math.max(low, value) / low)) / Math.log10(high / low));
  return {
    count,
    of,
    at: (i) => {
      const exact = low * (high / low) ** (i / count),
        plain = +exact.toPrecision(2);
      return of(plain) === i ? plain : +exact.toPrecision(3);
    },
  };
};
const linear = (low, step, count) => ({
  count,
  at: (i) => +(low + i * step).toPrecision(12),
  of: (value) => Math.round((value - low) / step),
});
const withZero = (scale) => ({
  count: scale.count + 1,
  at: (i) => (i ? scale.at(i - 1) : 0),
  of: (value) => (value > 0 ? scale.of(value) + 1 : 0),
});
const near1 = {
  count: 120,
  at: (i) => +(1 - 10 ** (-0.3 - (i * 2.7) / 120)).toPrecision(5),
  of: (value) => Math.round(((-Math.log10(1 - value) - 0.3) * 120) / 2.7),
};

/**
 * Name, label, unit, help, scale; a scale that depends on the world is a function of the model and the opening state.
 * @type {[keyof State & string, string, string, string, Places | ((model: Model, base: State) => Places | false |
 *   undefined)][]}
 */
export const SLIDERS = [
  [
    'alpha',
    'regularisation α',
    '',
    'Regularisation of the inverse: it keeps the share s²/(s²+α²) of each singular value s.',
    logarithmic(1e-9, 10),
  ],
  [
    'slope',
    'slope',
    '/ reward',
    'Steepness of the reward activation.',
    (model, base) => model.sloped && logarithmic(base.slope / 30, base.slope * 30, 60),
  ],
  [
    'slope_share',
    'slope',
    '· trained',
    'Softer than the trained activation, by a linear map over θ; its error is given under gamma-space. ' +
      'Rewards that are softened beyond the range of θ count in the outermost column, which moves means.',
    ({ arrays }) => arrays.places && linear(0.1, 0.05, 18),
  ],
  [
    'horizon',
    'horizon T',
    'steps',
    'Deadline of the episode, in steps of the world.',
    ({ horizons, dt, K }) => linear(horizons[0], dt, K - 1),
  ],
  [
    'used',
    'steps used',
    '',
    'Steps of the episode that are over: the time to go is T minus these.',
    ({ truth, K, dt }) => truth && linear(0, 1, Math.max(0, Math.floor(K * dt) - 1)),
  ],
  [
    'softness',
    'deadline softness',
    '· T',
    'Width of the deadline, as a share of the horizon; 0 is a hard one.',
    linear(0, 0.05, 20),
  ],
  ['value_gamma', 'γ in the value', '', 'Discount of the values that are compared.', near1],
  [
    'noise',
    'noise',
    '',
    'Noise in gamma-space: standard deviation of (1 − γ) Q, seeded.',
    withZero(logarithmic(1e-7, 0.1, 6)),
  ],
];

const LEADING = ['alpha', 'horizon']; // under tau-space; the others stand below all pictures
const MOST_TURNS = 3; // that are named

/** The places of the slider of alpha. */
export const ALPHAS = /** @type {Places} */ (SLIDERS[0][4]);

/**
 * The sliders of a model.
 * @param {Model} model
 * @param {State} base - the opening state
 * @param {Wish} wish
 * @param {boolean} leading - whether those under tau-space are wanted, or the others
 * @returns {{ box: HTMLElement, sync: (state: State, rule?: string | null) => void }} `rule`: title of the rule that
 *   chose alpha
 */
export function sliders(model, base, wish, leading) {
  const box = element('div', { class: leading ? 'sliders leading' : 'sliders' }),
    shown = {};
  for (const [name, label, unit, help, made] of SLIDERS) {
    if (LEADING.includes(name) !== leading) continue;
    const scale = typeof made === 'function' ? made(model, base) : made;
    if (!scale) continue;
    const output = element('output', {}),
      input = element('input', {
        type: 'range',
        min: 0,
        max: Math.max(1, scale.count),
        step: 1,
        title: help,
        name,
        'aria-label': label,
        disabled: scale.count < 1,
      });
    const byHand = name === 'alpha' ? { selector: 'typed' } : {}; // a drag takes alpha from the rule
    input.oninput = () => wish({ [name]: scale.at(+input.value), ...byHand }, false);
    input.onchange = () => wish({}, true);
    const extra =
      name === 'alpha'
        ? [
            element(
              'button',
              {
                type: 'button',
                class: 'small play',
                'aria-label': 'sweep alpha',
                title: 'Sweep alpha up and down',
                onclick: () => wish('play', true),
              },
              '▶',
            ),
          ]
        : name === 'noise'
          ? [
              element(
                'button',
                {
                  type: 'button',
                  class: 'small',
                  'aria-label': 'another noise',
                  title: 'Another seed',
                  onclick: () => wish('seed', true),
                },
                '⚄',
              ),
            ]
          : [];
    box.append(element('div', { class: 'slider' }, element('span', { class: 'name' }, label), ...extra, output, input));
    shown[name] = (state, rule) => {
      if (name === 'noise') extra[0].disabled = !state.noise;
      const at = scale.of(state[name]),
        chosen = name === 'alpha' && state.selector !== 'typed' ? ` · ${rule ?? state.selector}` : '',
        words = `${short(state[name], 4)}${unit ? ` ${unit}` : ''}${chosen}`;
      if (+input.value !== at) input.value = String(at);
      if (output.value !== words) {
        output.value = words;
        input.setAttribute('aria-valuetext', words);
      }
    };
  }
  return { box, sync: (state, rule) => Object.values(shown).forEach((show) => show(state, rule)) };
}

/**
 * Under the slider of alpha, the action that is chosen at each of its places, and the alphas where the choice turns.
 * @param {Model} model
 * @param {Wish} wish
 * @returns {{ box: HTMLElement, show: (turns?: { from: number, action: number }[]) => void }} without turns it says that
 *   they are being found
 */
export function turnsStrip({ header: { actions } }, wish) {
  const strip = element('div', { class: 'strip', 'aria-hidden': 'true' }),
    words = element('span', { class: 'group' }),
    box = element('div', { class: 'turns' }, strip, words);
  return {
    box,
    show(turns) {
      if (!turns) {
        box.classList.add('old');
        return;
      }
      box.classList.remove('old');
      strip.replaceChildren(
        ...turns.map(({ from, action }, i) => {
          const to = turns[i + 1]?.from ?? ALPHAS.count;
          return element('i', { style: `flex: ${to - from || 1}; background: ${actionColour(action)}` });
        }),
      );
      const found = turns.slice(1),
        button = ({ from, action }) =>
          element(
            'button',
            {
              type: 'button',
              class: 'tool',
              title: `from there on ${actions[action]} is chosen`,
              onclick: () => wish({ alpha: ALPHAS.at(from) }, true),
            },
            short(ALPHAS.at(from)),
          );
      words.replaceChildren(
        ...(found.length
          ? ['choice turns at α =', ...found.slice(-MOST_TURNS).map(button)]
          : [`${actions[turns[0].action]} is chosen at every α`]),
      );
    },
  };
}

/**
 * The switches of the artefacts, each with its size.
 * @param {Model} model
 * @param {Wish} wish
 * @returns {{ box: HTMLElement, sync: (state: State) => void, sizes: (effects: Record<string, Effect>) => void }}
 */
export function switchboard(model, wish) {
  const box = element('div', { class: 'switches', role: 'group', 'aria-label': 'artefacts' }),
    shown = {};
  const together = (words, on) =>
    element('button', { type: 'button', class: 'together', onclick: () => wish(on, true) }, words);
  const names = Object.keys(SWITCHES).filter((name) => available(model, name));
  const all = (on) =>
    Object.assign({}, ...names.map((name) => (on && name !== 'shift' ? SWITCHES[name].on : SWITCHES[name].off)));
  box.append(
    element('div', { class: 'pair' }, together('As the paper', all(true)), together('All repaired', all(false))),
  );
  for (const [name, each] of Object.entries(SWITCHES)) {
    const there = names.includes(name),
      size = element('span', { class: 'size' }, there ? ' ' : 'not available here');
    const button = element(
      'button',
      { type: 'button', role: 'switch', class: 'switch', name, title: each.help, disabled: !there },
      element('i', {}),
      element('b', {}, each.label),
      size,
    );
    box.append(button);
    shown[name] = {
      size,
      show: (state) => {
        button.setAttribute('aria-checked', String(there && each.isOn(state)));
        button.onclick = () => wish(each.isOn(state) ? each.off : each.on, true);
      },
    };
  }
  return {
    box,
    sync: (state) => Object.values(shown).forEach(({ show }) => show(state)),
    sizes(effects) {
      for (const [name, found] of Object.entries(effects)) {
        const moves =
          name === 'constant' ? '' : found.size < 5e-4 ? 'no effect here' : `moves ${short(found.size, 2)} probability`;
        const more = (found.on ?? NaN) - (found.off ?? NaN),
          told =
            found.on === undefined || found.off === undefined || model.A === 1
              ? ''
              : Math.abs(more) > 1e-6
                ? `regret ${short(found.off)} → ${short(found.on)}`
                : 'same choice';
        shown[name].size.textContent = [moves, told].filter(Boolean).join(' · ');
        shown[name].size.classList.toggle('large', more > 1e-6 || (found.size >= 0.05 && !(more < -1e-6)));
      }
    },
  };
}

/**
 * The row above the pictures: which action, how the spaces are drawn, scaling of the rows, history, A, the link.
 * @param {Model} model
 * @param {Wish} wish
 * @param {Told} told
 * @returns {{ box: HTMLElement, sync: (state: State, history: { states: State[], at: number }, told: Told,
 *   isWide: boolean) => void }}
 */
export function toolbar(model, wish, told) {
  const button = (kind, words, does, more) =>
    element('button', { type: 'button', class: kind, onclick: does, ...more }, words);
  const chips = model.header.actions.map((name, a) =>
    button('chip', name, () => wish({ action: a }, true), {
      style: `--chip: ${actionColour(a)}`,
      title: `show ${name}`,
    }),
  );
  const looks = ['heatmap', 'surface'].map((look) => button('chip', look, () => wish({ look }, true)));
  const rows = element(
    'select',
    {
      'aria-label': 'rows of tau-space',
      onchange: () => wish({ normalise: /** @type {State['normalise']} */ (rows.value) }, true),
    },
    ...[
      ['none', 'rows as decoded'],
      ['survival', 'rows given survival'],
      ['paper', 'rows rescaled to 1'],
    ].map(([value, words]) => element('option', { value }, words)),
  );
  const added = element(
    'select',
    {
      name: 'added',
      'aria-label': 'discounts added',
      title:
        'Discounts that were never trained, each interpolated between its two neighbours. They add no information, ' +
        'and let more noise through at the same α.',
      onchange: () => wish({ added: +added.value }, true),
    },
    ...['trained discounts', '+ 1 in each gap', '+ 2 in each gap', '+ 3 in each gap'].map((words, value) =>
      element('option', { value }, words),
    ),
  );
  const does = (words, name, title = name, keys = '') =>
    button('tool', words, () => wish(name, true), {
      'aria-label': name,
      title,
      'aria-keyshortcuts': keys || undefined,
    });
  const undo = does('↶', 'undo', 'undo (Ctrl+Z)', 'Control+Z'),
    redo = does('↷', 'redo', 'redo (Ctrl+Shift+Z)', 'Control+Shift+Z'),
    reset = does('reset', 'reset', 'back to the world’s own settings');
  const pin = button('tool', 'pin as A', () => wish('pin', true), {
    title: 'keep this view as A and compare what you change with it',
  });
  const link = button(
    'tool',
    'copy link',
    async () => {
      await navigator.clipboard.writeText(location.href).then(
        () => {
          link.textContent = 'copied';
        },
        () => {
          link.textContent = 'copy the address bar';
        },
      );
      setTimeout(() => {
        link.textContent = 'copy link';
      }, 1500);
    },
    { title: 'the address bar is a link to exactly this view' },
  );
  const wide = button('chip', 'all θ', () => wish('wide', true), {
      title: 'draw all sensitivities, not only those where rewards are',
    }),
    taken = button('chip', 'action taken', () => wish('follow', true), {
      title: 'look at the action that was taken at each step of the episode',
    });
  const group = (name, ...parts) => element('span', { class: 'group', role: 'group', 'aria-label': name }, ...parts);
  const box = element(
    'div',
    { class: 'toolbar' },
    group('action', ...chips, taken),
    group('drawing', ...looks, wide),
    rows,
    ...(model.arrays.places && told.live ? [added] : []),
    group('history', undo, redo, reset),
    ...(told.live ? [group('keep', ...(told.pinnable ? [pin] : []), link)] : []),
  );
  return {
    box,
    sync(state, history, { pinned, followed, follows }, isWide) {
      wide.setAttribute('aria-pressed', String(isWide));
      taken.hidden = !followed;
      taken.setAttribute('aria-pressed', String(Boolean(follows)));
      chips.forEach((chip, a) => chip.setAttribute('aria-pressed', String(a === state.action)));
      looks.forEach((chip) => chip.setAttribute('aria-pressed', String(chip.textContent === state.look)));
      rows.value = state.normalise;
      added.value = String(state.added);
      undo.disabled = history.at <= 0;
      redo.disabled = history.at >= history.states.length - 1;
      pin.textContent = pinned ? 'unpin A' : 'pin as A';
    },
  };
}

/**
 * The row below: examples, and files to save.
 * @param {Preset[]} presets
 * @param {[string, () => void][]} files - a name each, and what saves it
 * @param {Wish} wish
 * @returns {HTMLElement}
 */
export function footer(presets, files, wish) {
  const box = element('div', { class: 'footer' });
  if (presets.length)
    box.append(
      element(
        'span',
        { class: 'group', role: 'group', 'aria-label': 'examples' },
        element('span', { class: 'name' }, 'See'),
        ...presets.map((preset) =>
          element('button', { type: 'button', class: 'tool', onclick: () => wish({ preset }, true) }, preset.name),
        ),
      ),
    );
  box.append(
    element(
      'span',
      { class: 'group', role: 'group', 'aria-label': 'downloads' },
      element('span', { class: 'name' }, 'Save'),
      ...files.map(([words, save]) =>
        element('button', { type: 'button', class: 'tool', 'aria-label': `save ${words}`, onclick: save }, words),
      ),
    ),
  );
  return box;
}
