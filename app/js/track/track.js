// The race track inside Streamlit: both episodes under one cursor, buttons, and both returns until the deadline.
import { element } from '../draw/elements.js';
import { button, component, stepper } from '../cursor/cursor.js';
import { NEUTRAL, axes, line, rounded, sheet, short, ticks } from '../draw/drawing.js';

// A race as it is drawn: of each side the return after 0, 1, ... steps.
function opened(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset),
    length = view.getUint32(0, true);
  const race = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  race.pictures = bytes.slice(4 + length);
  for (const side of race.sides) {
    side.steps = side.rewards.length;
    side.returns = side.rewards.reduce((all, reward) => [...all, all.at(-1) + reward], [0]);
  }
  race.last = Math.max(...race.sides.map((side) => side.steps));
  return race;
}

export default component({
  kind: 'track',
  open: opened,
  mount,
  shown: (told) => JSON.stringify([told.id, told.names]),
});

const returnAfter = (side, step) => side.returns[Math.min(step, side.steps)];

function mount(host, race, told, report) {
  const { last, sides } = race;
  const at = stepper({ host, told, last, name: 'over', label: 'steps that are over', show, report });

  const lanes = sides.map((side, i) => lane(race, side, told.names[i], told.colours[i], told.actions));
  const canvas = element('canvas', {
    class: 'course',
    role: 'img',
    'aria-label':
      `Returns until the deadline T = ${race.horizon}: ` +
      sides
        .map((side, i) => `${told.names[i]} ${short(side.returns[side.steps], 4)} after ${side.steps} steps`)
        .join(', '),
  });
  const parting = button(
    race.parting === null ? 'never apart' : `first apart · ${race.parting + 1}`,
    'the first step at which the actions differ',
    () => at.to(race.parting + 1),
    false,
  );
  parting.disabled = race.parting === null;
  const where = element('b', {}),
    ahead = element('span', { class: 'ahead' });
  host.append(
    element('div', { class: 'lanes' }, ...lanes.map((one) => one.box)),
    canvas,
    at.bar,
    element('div', { class: 'buttons' }, ...at.moves, parting, where, ahead),
  );

  function show() {
    const { step } = at;
    lanes.forEach((one) => one.at(step));
    at.bar.value = String(step);
    at.bar.setAttribute('aria-valuetext', `${step} of ${race.horizon} steps`);
    where.textContent = `step ${step} of ${race.horizon}`;
    const lead = returnAfter(sides[1], step) - returnAfter(sides[0], step);
    ahead.textContent =
      Math.abs(lead) < 1e-9 ? 'level' : `${told.names[lead > 0 ? 1 : 0]} ahead by ${Math.abs(lead).toFixed(1)}`;
    draw();
  }

  function draw() {
    const found = sheet(canvas, getComputedStyle(host).fontFamily),
      colours = { text: getComputedStyle(host).color, soft: NEUTRAL };
    if (found) canvas.toStep = course(found.pen, found.width, found.height, race, told, at.step, colours);
  }

  at.over(canvas);
  new ResizeObserver(draw).observe(canvas);
  host.addEventListener('transitionend', (event) => {
    if (event.target === host) draw();
  }); // its colour follows the theme
  show();
  return { stop: at.stop, place: at.place, cursor: at };
}

// One side: its picture after so many steps, the step that led there, and the return so far.
function lane(race, side, name, colour, actions) {
  const picture = element('img', { class: 'frame', alt: `${name}: the environment after this step` });
  const total = element('output', {}),
    did = element('b', {}),
    got = element('b', {}),
    note = element('p', {});
  const facts = element(
    'div',
    { class: 'facts' },
    element('h2', {}, element('i', { style: `background: ${colour}` }), name),
    element('div', { class: 'row total' }, element('span', {}, 'return'), total),
    element('div', { class: 'row' }, element('span', {}, 'action'), did),
    element('div', { class: 'row' }, element('span', {}, 'reward'), got),
    note,
  );
  const box = element('div', { class: 'lane' }, ...(side.ends.length ? [picture] : []), facts);
  const first = race.sides[0].ends.at(-1) ?? 0; // where the pictures of the right side begin
  let url,
    shown = -1;
  return {
    box,
    at(step) {
      const own = Math.min(step, side.steps),
        over = step >= side.steps && side.steps < race.horizon;
      if (side.ends.length && own !== shown) {
        const begin = own ? side.ends[own - 1] : side === race.sides[0] ? 0 : first,
          old = url;
        picture.src = url = URL.createObjectURL(
          new Blob([race.pictures.subarray(begin, side.ends[own])], { type: 'image/jpeg' }),
        );
        if (old) setTimeout(() => URL.revokeObjectURL(old), 500);
        shown = own;
      }
      total.textContent = side.returns[own].toFixed(1);
      did.textContent = step && step <= side.steps ? actions[side.actions[step - 1]] : '–';
      got.textContent = step && step <= side.steps ? short(side.rewards[step - 1]) : '–';
      note.textContent = over ? `${side.terminated ? 'over' : 'cut off'} after ${side.steps} steps` : '';
      box.classList.toggle('over', over);
    },
  };
}

// Both returns over the steps, their difference under them, the deadline, the first step apart and the cursor.
function course(pen, w, h, { sides, horizon, parting, last }, told, step, colours) {
  const x = [0, horizon * 1.02],
    gap = 14,
    room = h - 44,
    high = Math.round(room * 0.64),
    left = 52,
    right = 10;
  const upper = { x: left, y: 6, w: w - left - right, h: high },
    lower = { ...upper, y: 6 + high + gap, h: room - high - gap };
  const differences = Array.from({ length: last + 1 }, (_, t) => returnAfter(sides[1], t) - returnAfter(sides[0], t));
  const range = (all) => {
    const [from, to] = [Math.min(0, ...all), Math.max(0, ...all)];
    return to - from > 1e-6 ? rounded(from, to) : [-1, 1];
  };
  const whole = ticks(x[0], x[1], Math.max(3, Math.min(10, w / 90))).filter((t) => Number.isInteger(t));
  const y = range(sides.flatMap((side) => side.returns)),
    below = range(differences);
  const top = axes(pen, upper, { x, y, xTicks: whole.map((t) => [t, '']), yTitle: 'return', colours });
  const low = axes(pen, lower, {
    x,
    y: below,
    xTicks: whole,
    yTicks: below[0] && below[1] ? [below[0], 0, below[1]] : below,
    xTitle: 'steps',
    yTitle: 'lead',
    colours,
  });
  const end = [
    [top.X(horizon), upper.y],
    [top.X(horizon), lower.y + lower.h],
  ];
  pen.path(end, { stroke: colours.text, width: 1.4, dash: [5, 4] });
  pen.text(`deadline T = ${horizon}`, top.X(horizon) - 6, upper.y + upper.h - 6, {
    align: 'right',
    colour: colours.text,
    size: 11,
  });
  if (parting !== null) {
    pen.path(
      [
        [top.X(parting + 1), upper.y],
        [top.X(parting + 1), lower.y + lower.h],
      ],
      { stroke: NEUTRAL, width: 1, dash: [2, 3] },
    );
  }
  sides.forEach((side, i) => {
    line(
      pen,
      side.returns.map((_, t) => top.X(t)),
      side.returns.map(top.Y),
      { stroke: told.colours[i], width: i ? 1.8 : 3.2 },
    ); // one on the other, both are seen
    if (side.steps < horizon) {
      const after = top.Y(side.returns.at(-1));
      pen.path(
        [
          [top.X(side.steps), after],
          [top.X(horizon), after],
        ],
        { stroke: told.colours[i], width: 1.4, dash: [2, 4] },
      );
    }
  });
  differences.slice(1).forEach((lead, i) => {
    // a bar a step, in the colour of the side that leads
    const from = low.X(i + 0.5),
      to = low.X(Math.min(horizon, i + 1.5));
    pen.path(
      [
        [from, low.Y(0)],
        [to, low.Y(0)],
        [to, low.Y(lead)],
        [from, low.Y(lead)],
      ],
      { fill: told.colours[lead > 0 ? 1 : 0], close: true },
    );
  });
  pen.path(
    [
      [low.X(0), low.Y(0)],
      [low.X(x[1]), low.Y(0)],
    ],
    { stroke: NEUTRAL },
  );
  pen.path(
    [
      [top.X(step), upper.y],
      [top.X(step), lower.y + lower.h],
    ],
    { stroke: '#ff9f1c', width: 2 },
  );
  sides.forEach((side, i) => {
    const [cx, cy] = [top.X(step), top.Y(returnAfter(side, step))],
      ring = Array.from({ length: 13 }, (_, k) => [
        cx + 4 * Math.cos((k * Math.PI) / 6),
        cy + 4 * Math.sin((k * Math.PI) / 6),
      ]);
    pen.path(ring, { fill: told.colours[i], close: true });
  });
  return (px) => Math.round(top.toX(px));
}
