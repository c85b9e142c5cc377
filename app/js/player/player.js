// The player inside Streamlit: the frame, a timeline to drag over, buttons, and the numbers of the step under the
// cursor.
import { element } from '../draw/elements.js';
import { button, component, stepper } from '../cursor/cursor.js';
import { NEUTRAL, actionColour, axes, line, rounded, sheet, short } from '../draw/drawing.js';
import { hub } from '../hub.js';
import { follow } from './peers.js';
import { bySurprise, followedAt, frameAt, modelAt, nextMarked, openReel, ownAt } from './reel.js';

const ASK = 400; // ms between two requests for the result of a search in the background
const MEANINGS = {
  predicted: 'discounted return that the agent predicted for the action taken',
  observed:
    'discounted return that was observed; where the episode was cut off, the best value of the last observation ' +
    'stands for the rest (≈: it has more than 5% of the weight)',
  'TD error': 'reward + γ · best value of the next observation − value of the action taken',
};

export default component({ kind: 'player', mount, open: async (bytes, id) => ({ ...(await openReel(bytes)), id }) });

function mount(host, reel, told, report) {
  const last = reel.steps - 1,
    order = bySurprise(reel),
    differ = reel.differs.reduce((a, b) => a + b, 0);
  let url,
    rank = -1,
    flags,
    begins,
    asking,
    asked = 0;
  const returns = Float64Array.from(reel.rewards);
  for (let t = 1; t <= last; t++) returns[t] += returns[t - 1];
  host.times = [];

  const frame = element('img', { class: 'frame', alt: 'the environment before this step' });
  const canvas = element('canvas', {
    class: 'reel',
    role: 'img',
    'aria-label':
      `Rewards and TD errors of an episode of ${reel.steps} steps: return ${short(returns[last], 4)}, ` +
      `largest TD error ${short(reel.surprise[order[0]])} at step ${order[0]}`,
  });
  const at = stepper({ host, told, last, name: 'step', label: 'step of the episode', show, report });
  const differs = button(
    differ ? `non-greedy › ${differ}` : 'always greedy',
    'next step with an action that is not the greedy one',
    () => at.to(nextMarked(reel.differs, at.step)),
    false,
  );
  differs.disabled = !differ;
  const surprise = button(
    'TD error ›',
    'step with the largest TD error; press again for the next largest',
    () => {
      // on from the last one, while it is still shown
      rank = order[rank] === at.step ? (rank + 1) % Math.min(order.length, 10) : 0;
      at.to(order[rank]);
    },
    false,
  );
  const artefact = button('artefact ›', '', () => at.to(nextMarked(begins, at.step)));
  const where = element('b', {}),
    here = element('span', { class: 'here' });
  const values = element('table', { class: 'values' }),
    seen = element('table', { class: 'seen' });
  const moves = element('div', { class: 'buttons' }, ...at.moves);
  const jumps = element('div', { class: 'buttons' }, differs, surprise, artefact);
  const facts = element('table', { class: 'facts' }),
    numbers = element(
      'div',
      { class: 'numbers' },
      element('div', {}, values, facts),
      ...(told.names.length ? [seen] : []),
    );
  const middle = element(
    'div',
    { class: 'middle' },
    element('div', { class: 'line' }, where, here),
    canvas,
    at.bar,
    ...(reel.ends.length ? [] : [moves]),
    jumps,
  );
  host.append(...(reel.ends.length ? [element('div', { class: 'screen' }, frame, moves)] : []), middle, numbers);

  const cell = (words, kind = '') => element('td', { class: kind }, words);
  const valueRows = told.actions.map((name, a) => {
    const cells = [cell('', 'mark'), cell(name), cell('', 'number'), cell('', 'number')];
    cells[0].style.color = actionColour(a);
    values.append(element('tr', {}, ...cells));
    return cells;
  });
  values.prepend(element('tr', {}, cell(''), cell('action'), cell('value (rule)', 'number'), cell('greedy', 'number')));
  const gamma = `(γ ${short(reel.acting_gamma)})`;
  const factCells = ['reward', 'return so far', `predicted ${gamma}`, `observed ${gamma}`, 'TD error'].map((name) => {
    const value = cell('', 'number');
    facts.append(element('tr', { title: MEANINGS[name.split(' (')[0]] }, cell(name), value));
    return value;
  });
  const seenCells = told.names.map(([name, unit]) => {
    const value = cell('', 'number');
    seen.append(element('tr', {}, cell(name), value, cell(unit)));
    return value;
  });

  const lead = (hub.leader = {
    id: told.id,
    get step() {
      return at.step;
    },
    over(model) {
      return [modelAt(reel, at.step, model), { said: null, followed: followedAt(reel, at.step) }];
    },
  });

  // Artefacts of the action taken: bits of names, a number a step; none while the server looks for them.
  function flag(news) {
    clearTimeout(asking);
    if (!news) asking = setTimeout(() => host.isConnected && report({ flags: ++asked, id: told.id }), ASK);
    if (JSON.stringify(news) === JSON.stringify(flags)) return;
    flags = news;
    begins = flags?.marks.map((mark, t) => mark & ~(t && flags.marks[t - 1]));
    const places = begins?.filter(Boolean).length,
      many = (i) => flags.marks.filter((mark) => mark & (1 << i)).length;
    const counted = flags?.names.map((name, i) => `${name} at ${many(i)}`);
    artefact.disabled = !places;
    artefact.hidden = flags?.marks.length === 0; // nothing is decoded
    artefact.textContent = !flags ? 'artefacts …' : places ? `artefact › ${places}` : 'no artefact';
    artefact.title = !flags
      ? 'searching for artefacts'
      : `next step at which an artefact of the action taken begins, at α ${short(flags.alpha)}; ` +
        `${counted.join(', ') || 'none'} of ${last + 1} steps`;
    artefact.setAttribute('aria-label', artefact.textContent);
    draw();
  }

  function show() {
    const began = performance.now(),
      { lens } = hub;
    if (!reel.levels)
      follow(reel, at.step); // no gamma-space, no lens
    else if (lens && hub.leader === lead) {
      const [model, news] = lead.over(lens.model);
      lens.show(model, news, false);
    }
    draw();
    host.times.push(performance.now() - began);
    if (host.times.length > 500) host.times.shift();
  }

  function draw() {
    const { step } = at,
      picture = frameAt(reel, step);
    if (picture) {
      const old = url;
      frame.src = url = URL.createObjectURL(new Blob([picture], { type: 'image/jpeg' }));
      if (old) setTimeout(() => URL.revokeObjectURL(old), 500);
    }
    at.bar.value = String(step);
    where.textContent = `step ${step} of ${last}`;
    here.textContent = flags?.names.filter((_, i) => flags.marks[step] & (1 << i)).join(' · ') ?? '';
    [reel.rewards[step], returns[step], reel.predicted[step], reel.received[step], reel.surprise[step]].forEach(
      (value, i) => {
        factCells[i].textContent = (i === 3 && ownAt(reel, step) ? '≈ ' : '') + short(value, 4);
      },
    );
    const A = reel.actions;
    valueRows.forEach(([mark, , rule, greedy], a) => {
      const taken = reel.taken[step] === a;
      mark.textContent = taken ? '●' : '○';
      mark.parentElement.classList.toggle('taken', taken);
      rule.textContent = short(reel.values[step * A + a], 4);
      greedy.textContent = short(reel.greedy_values[step * A + a], 4);
    });
    seenCells.forEach((value, i) => {
      value.textContent = short(reel.observations[step * told.names.length + i]);
    });
    drawReel();
  }

  function drawReel() {
    const found = sheet(canvas, getComputedStyle(host).fontFamily),
      { step } = at;
    if (!found) return;
    const { pen, width: w, height: h } = found,
      colours = { text: getComputedStyle(host).color, soft: NEUTRAL },
      x = [-0.5, last + 0.5];
    const range = (all) =>
      rounded(
        all.reduce((a, b) => Math.min(a, b), 0),
        all.reduce((a, b) => Math.max(a, b), 0),
      );
    const half = (h - 24) / 2,
      upper = { x: 46, y: 4, w: w - 56, h: half - 8 },
      lower = { ...upper, y: half + 12, h: half - 8 };
    const top = axes(pen, upper, {
      x,
      y: range(reel.rewards),
      yTicks: range(reel.rewards),
      xTicks: [],
      yTitle: 'reward',
      colours,
    });
    const low = axes(pen, lower, {
      x,
      y: range(reel.surprise),
      yTicks: range(reel.surprise),
      yTitle: 'TD error',
      colours,
    });
    const bars = [],
      flagged = flags?.marks.flatMap((mark, t) => (mark ? [[top.X(t - 0.5), 1.5], [top.X(t + 0.5), 1.5], null] : []));
    if (flagged) pen.path(flagged, { stroke: '#e8a100', width: 3 });
    reel.rewards.forEach((reward, t) => bars.push([top.X(t), top.Y(0)], [top.X(t), top.Y(reward)], null));
    pen.path(bars, { stroke: NEUTRAL, width: Math.max(1, Math.min(6, (0.7 * upper.w) / (last + 1))) });
    line(
      pen,
      Array.from(reel.surprise, (_, t) => low.X(t)),
      reel.surprise.map(low.Y),
      { stroke: '#d6336c', width: 1.3 },
    );
    reel.differs.forEach((mark, t) => {
      if (mark)
        pen.path(
          [
            [low.X(t), upper.y + upper.h],
            [low.X(t), lower.y],
          ],
          { stroke: actionColour(reel.taken[t]), width: 2 },
        );
    });
    pen.path(
      [
        [top.X(step), upper.y],
        [top.X(step), lower.y + lower.h],
      ],
      { stroke: '#ff9f1c', width: 2 },
    );
    canvas.toStep = (px) => Math.round(((px - upper.x) / upper.w) * (last + 1) - 0.5);
  }

  at.over(canvas);
  new ResizeObserver(drawReel).observe(host);
  host.addEventListener('transitionend', (event) => {
    if (event.target === host) drawReel();
  }); // its colour follows the theme
  const { lens } = hub,
    exact =
      lens?.lead &&
      lens.lead.id === told.id &&
      lens.lead.step === at.step &&
      !String(lens.model.id).startsWith(reel.id);
  if (exact) draw();
  else show(); // what Python has told the lens of this very step is better
  flag(told.flags);
  return { stop: at.stop, place: at.place, cursor: at, news: ({ flags: news }) => flag(news) };
}
