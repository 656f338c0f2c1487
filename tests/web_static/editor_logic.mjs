// What the editor does to documents, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { serveReference } from "./served.mjs";

await serveReference(process.argv[2], process.argv[3]);

const from = (name) => import(pathToFileURL(`${process.argv[2]}/editor/${name}.js`));
const documents = await from("document");
const { insertDoor, removeDoor, changeDoor } = await from("doors");
const { newHistory, addStep, stepBack, stepForward } = await from("history");
const { tap, finishLine, withTool, erase, placeChosen } = await from("tools");
const { toPlace, toPixel, zoomView, panView, fitView } = await from("viewport");
const { lengthOf } = await from("geometry");
const { snap, snapPlace } = await from("snap");
const { add, change, emptyPlan, moveBy, moveTo, nameFrom, newPath, pointsOf, remove, itemNear } = documents;

const HOW = { step: 0.1, reach: 0.3 };
const frozen = (value) => {
  if (value && typeof value === "object" && !Object.isFrozen(value)) {
    Object.freeze(value);
    Object.values(value).forEach(frozen);
  }
  return value;
};
const fresh = (tool, plan = emptyPlan("Room")) => frozen({ plan, tool, pending: [], chosen: null, doorWidth: 1 });
const taps = (state, ...places) => places.reduce((now, place) => frozen(tap(now, place, HOW)), state);
const near = (a, b) => assert.ok(Math.hypot(a[0] - b[0], a[1] - b[1]) < 1e-3, `${a} is not ${b}`);
const ROOM = [
  [0, 0],
  [6, 0],
  [6, 4],
  [0, 4],
];

const tests = {
  "a wall goes from tap to tap and snaps to the grid"() {
    const done = finishLine(taps(fresh("wall"), [0.03, -0.04], [5.96, 0.02], [6.04, 4.01]));
    assert.deepEqual(done.plan.walls, [
      [
        [0, 0],
        [6, 0],
        [6, 4],
      ],
    ]);
    assert.deepEqual(done.chosen, { list: "walls", index: 0 });
    assert.deepEqual(done.pending, []);
  },
  "tapping the last corner again ends a wall, the first one closes it"() {
    const ended = taps(fresh("wall"), [0, 0], [3, 0], [3.01, 0.01]);
    assert.deepEqual(ended.plan.walls, [
      [
        [0, 0],
        [3, 0],
      ],
    ]);
    const closed = taps(fresh("wall"), ...ROOM, [0.05, 0.02]);
    assert.deepEqual(closed.plan.walls, [[...ROOM, [0, 0]]]);
    assert.deepEqual(taps(fresh("wall"), [0, 0], [0, 0]).plan.walls, []);
  },
  "another tool finishes a line that was begun"() {
    const next = withTool(taps(fresh("wall"), [0, 0], [3, 0]), "path");
    assert.equal(next.tool, "path");
    assert.deepEqual(next.plan.walls, [
      [
        [0, 0],
        [3, 0],
      ],
    ]);
  },
  "a place near a wall's end snaps to it, without the grid to nothing"() {
    const plan = {
      ...emptyPlan("x"),
      walls: [
        [
          [0.123, 0.456],
          [3, 0],
        ],
      ],
    };
    assert.deepEqual(snapPlace(plan, [0.2, 0.5], 0.1, 0.3), [0.123, 0.456]);
    assert.deepEqual(snapPlace(plan, [1.234, 2.345], 0.1, 0.3), [1.2, 2.3]);
    assert.deepEqual(snapPlace(plan, [0.2, 0.51], 0, 0.3), [0.2, 0.51]);
    assert.ok(Object.is(snap([-0.01, 0], 0.1)[0], 0));
  },
  "a door is a gap of its clear width, and goes without a trace"() {
    const plan = frozen({
      ...emptyPlan("x"),
      walls: [
        [
          [0, 0],
          [6, 0],
          [6, 4],
        ],
      ],
    });
    const made = insertDoor(plan, [2, 0.1], 1, 0.3);
    assert.deepEqual(made.plan.doors, [{ position: [2, 0], width: 1, heading: 1.5708 }]);
    assert.deepEqual(made.plan.walls, [
      [
        [0, 0],
        [1.45, 0],
      ],
      [
        [2.55, 0],
        [6, 0],
        [6, 4],
      ],
    ]);
    assert.deepEqual(removeDoor(made.plan, made.ref), plan);
    assert.deepEqual(plan.walls.length, 1);
  },
  "a door at the end of a wall, and in a closed one"() {
    const plan = frozen({ ...emptyPlan("x"), walls: [[...ROOM, [0, 0]]] });
    for (const place of [
      [0, 0.2],
      [5.9, 0],
      [6, 2],
      [3, 4],
      [0.1, 4],
    ]) {
      const made = insertDoor(plan, place, 0.9, 0.5);
      const gone = removeDoor(made.plan, made.ref);
      assert.ok(Math.abs(lengthOf(plan.walls[0]) - gone.walls.reduce((sum, wall) => sum + lengthOf(wall), 0)) < 1e-3);
      assert.equal(gone.doors.length, 0);
    }
  },
  "a door that does not fit is refused, one that is moved stays when it fits nowhere"() {
    const plan = {
      ...emptyPlan("x"),
      walls: [
        [
          [0, 0],
          [1, 0],
        ],
        [
          [0, 3],
          [4, 3],
        ],
      ],
    };
    assert.equal(insertDoor(plan, [0.5, 0], 1, 0.3).problem, "too-short");
    assert.equal(insertDoor(plan, [0.5, 1.5], 1, 0.3).problem, "no-wall");
    const made = insertDoor(plan, [2, 3], 1, 0.3);
    const kept = changeDoor(made.plan, made.ref, [2, 3], 9, 0.5);
    assert.equal(kept.problem, "too-short");
    assert.deepEqual(kept.plan, made.plan);
    const wider = changeDoor(made.plan, made.ref, [2, 3], 1.4, 0.5);
    assert.deepEqual(wider.plan.doors[0].width, 1.4);
    near(wider.plan.walls[1][1], [1.25, 3]);
    const moved = placeChosen({ ...fresh("move", made.plan), chosen: made.ref }, [3, 3], 0.3);
    near(moved.plan.doors[0].position, [3, 3]);
    assert.equal(moved.plan.walls.length, 3);
    assert.ok(tap(fresh("door", plan), [9, 9], HOW).words.startsWith("editor-door-"));
  },
  "boxes, round things and cones"() {
    const box = taps(fresh("box"), [1, 1], [3, 2]).plan.obstacles[0];
    assert.deepEqual(
      [box.position, box.size],
      [
        [2, 1.5],
        [2, 1],
      ],
    );
    const round = taps(fresh("round"), [1, 1], [1.5, 1]).plan.obstacles[0];
    assert.deepEqual([round.kind, round.position, round.radius], ["cylinder", [1, 1], 0.5]);
    assert.deepEqual(taps(fresh("cone"), [1, 1]).plan.cones[0].position, [1, 1]);
    assert.ok(taps(fresh("box"), [1, 1], [1, 1]).plan.obstacles[0].size.every((side) => side > 0));
  },
  "paths get names of their own"() {
    let state = finishLine(taps(fresh("path"), [1, 1], [5, 1], [5, 4]));
    state = finishLine(taps({ ...state, tool: "path" }, [0, 0], [40, 0]));
    assert.deepEqual(
      state.plan.paths.map(({ name }) => name),
      ["main", "path-2"],
    );
    assert.equal(state.plan.paths[0].time_limit, 60);
    assert.equal(state.plan.paths[1].time_limit, 160);
    assert.equal(
      newPath({ paths: [{ name: "path-2" }, { name: "main" }] }, [
        [0, 0],
        [1, 0],
      ]).name,
      "path-3",
    );
  },
  "the start heading goes from the start to the tap"() {
    const plan = finishLine(taps(fresh("path"), [1, 1], [5, 1])).plan;
    const turned = tap(fresh("heading", plan), [1, 3], HOW);
    assert.equal(turned.plan.paths[0].start_heading, 1.5708);
    const two = add(
      plan,
      "paths",
      newPath(plan, [
        [0, 5],
        [5, 5],
      ]),
    ).plan;
    assert.equal(tap(fresh("heading", two), [9, 9], HOW).words, "editor-heading-choose");
    const chosen = tap(fresh("heading", two), [2, 5], HOW);
    assert.equal(chosen.words, "editor-heading-now");
    assert.equal(tap(chosen, [0, 4], HOW).plan.paths[1].start_heading, -1.5708);
    assert.equal(
      change(turned.plan, { list: "paths", index: 0 }, { start_heading: undefined }).paths[0].start_heading,
      undefined,
    );
  },
  "choosing, moving by numbers and erasing"() {
    const plan = {
      ...emptyPlan("x"),
      walls: [
        [
          [0, 0],
          [4, 0],
          [4, 3],
        ],
      ],
      cones: [{ position: [2, 2], radius: 0.15 }],
    };
    const wall = tap(fresh("move", plan), [2, 0.1], HOW).chosen;
    assert.deepEqual(wall, { list: "walls", index: 0 });
    const corner = tap({ ...fresh("move", plan), chosen: wall }, [4, 0.1], HOW).chosen;
    assert.deepEqual(corner, { list: "walls", index: 0, point: 1 });
    assert.deepEqual(moveBy(plan, corner, 0.1, 0).walls[0], [
      [0, 0],
      [4.1, 0],
      [4, 3],
    ]);
    assert.deepEqual(moveTo(plan, wall, [1, 1]).walls[0], [
      [1, 1],
      [5, 1],
      [5, 4],
    ]);
    assert.equal(tap(fresh("move", plan), [1, 2], HOW).chosen, null);
    const gone = tap(fresh("erase", plan), [2, 2], HOW).plan;
    assert.deepEqual([gone.cones.length, gone.walls.length], [0, 1]);
    assert.deepEqual(
      pointsOf(placeChosen({ ...fresh("move", plan), chosen: { list: "cones", index: 0 } }, [3, 1], 0.3).plan, {
        list: "cones",
        index: 0,
      }),
      [[3, 1]],
    );
    assert.equal(tap({ ...fresh("placing", plan), chosen: { list: "cones", index: 0 } }, [3, 1], HOW).tool, "move");
  },
  "a turned box is hit where it stands"() {
    const plan = {
      ...emptyPlan("x"),
      obstacles: [{ kind: "box", position: [0, 0], size: [4, 0.2], angle: Math.PI / 2 }],
    };
    assert.ok(itemNear(plan, [0, 1.9], 0.1, null));
    assert.equal(itemNear(plan, [1.9, 0], 0.1, null), null);
  },
  "points are added and left out, and two stay"() {
    const plan = {
      ...emptyPlan("x"),
      walls: [
        [
          [0, 0],
          [4, 0],
        ],
      ],
    };
    const more = documents.insertPoint(plan, { list: "walls", index: 0, point: 0 });
    assert.deepEqual(more.plan.walls[0], [
      [0, 0],
      [2, 0],
      [4, 0],
    ]);
    const end = documents.insertPoint(plan, { list: "walls", index: 0, point: 1 });
    assert.deepEqual(end.plan.walls[0], [
      [0, 0],
      [4, 0],
      [5, 0],
    ]);
    assert.deepEqual(documents.removePoint(more.plan, more.ref).plan, plan);
    assert.deepEqual(documents.removePoint(plan, { list: "walls", index: 0, point: 1 }).plan, plan);
  },
  "fields that the editor does not know stay"() {
    const plan = {
      ...emptyPlan("x"),
      movers: [
        {
          name: "m",
          points: [
            [0, 0],
            [1, 0],
          ],
        },
      ],
      lights: { sun: 0.5 },
    };
    const next = taps(fresh("cone", plan), [1, 1]).plan;
    assert.deepEqual([next.movers, next.lights], [plan.movers, plan.lights]);
    assert.deepEqual(erase(fresh("erase", next), { list: "movers", index: 0 }).plan.movers, []);
    assert.deepEqual(remove(next, { list: "cones", index: 0 }).cones, []);
  },
  "undo and redo, step by step"() {
    let history = newHistory(0);
    for (const step of [1, 2, 3]) history = addStep(history, step);
    assert.equal(addStep(history, 3), history);
    history = stepBack(stepBack(history));
    assert.equal(history.now, 1);
    history = stepForward(history);
    assert.equal(history.now, 2);
    history = addStep(history, 9);
    assert.equal(stepForward(history), history);
    assert.equal(stepBack(stepBack(stepBack(stepBack(history)))).now, 0);
    for (let i = 0; i < 500; i += 1) history = addStep(history, i + 10);
    assert.equal(history.past.length, 200);
  },
  "undoing everything gives what there was"() {
    let state = fresh("wall");
    let history = newHistory(state.plan);
    const first = JSON.stringify(state.plan);
    const places = [
      [0, 0],
      [6, 0],
      [6, 4],
      [0, 4],
      [0, 0],
      [3, 0],
      [1, 1],
      [5, 3],
      [2, 0],
      [2, 2],
    ];
    let seed = 7;
    const random = (n) => (seed = (seed * 16807) % 2147483647) % n;
    const tools = ["wall", "door", "box", "round", "cone", "path", "heading", "erase", "move"];
    for (let i = 0; i < 400; i += 1) {
      const next = random(4) ? tap(state, places[random(places.length)], HOW) : withTool(state, tools[random(9)]);
      history = addStep(history, next.plan);
      state = frozen(next);
      for (const wall of state.plan.walls) assert.ok(wall.length > 1 && wall.flat().every(Number.isFinite));
      for (const path of state.plan.paths) assert.ok(path.points.length > 1);
    }
    const last = JSON.stringify(history.now);
    const steps = history.past.length;
    assert.ok(steps > 50);
    for (let i = 0; i < steps; i += 1) history = stepBack(history);
    if (steps < 200) assert.equal(JSON.stringify(history.now), first);
    for (let i = 0; i < steps; i += 1) history = stepForward(history);
    assert.equal(JSON.stringify(history.now), last);
  },
  "names are made of titles, and none is taken twice"() {
    assert.equal(nameFrom("Grosser Raum, 2. Stock", []), "grosser-raum-2-stock");
    assert.equal(nameFrom("Café", []), "cafe");
    assert.equal(nameFrom("房间", []), "plan");
    assert.equal(nameFrom("Hall", ["hall", "Hall-2"]), "hall-3");
    assert.equal(nameFrom("Desert", ["desert.easy"]), "desert-2");
    assert.match(nameFrom("x".repeat(300), ["x".repeat(56)]), /^[a-z0-9-]{1,64}$/);
  },
  "a pixel is where its place is, and zooming keeps it"() {
    const size = { width: 800, height: 600 };
    const view = { x: 3, y: 2, scale: 50 };
    near(toPlace(view, size, [400, 300]), [3, 2]);
    near(toPlace(view, size, [450, 250]), [4, 3]);
    near(toPixel(view, size, [4, 3]), [450, 250]);
    const closer = zoomView(view, size, 1.7, [100, 500]);
    near(toPlace(closer, size, [100, 500]), toPlace(view, size, [100, 500]));
    near(toPlace(panView(view, 50, 0), size, [450, 300]), toPlace(view, size, [400, 300]));
    assert.equal(zoomView(view, size, 1e9).scale, 400);
    const whole = fitView({ x: 0, y: 0, width: 20, height: 5 }, size);
    assert.ok(toPixel(whole, size, [20, 5])[0] < 800 && toPixel(whole, size, [0, 0])[0] > 0);
    assert.ok(fitView(null, size).scale > 0);
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    test();
  } catch (error) {
    failed += 1;
    console.error(`${name}: ${error.stack}`);
  }
}
console.log(`${Object.keys(tests).length - failed} of ${Object.keys(tests).length} hold`);
process.exitCode = failed ? 1 : 0;
