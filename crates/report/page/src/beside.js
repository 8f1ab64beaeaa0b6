// The page of two plans of the same parts: both move at the same time, and one table has the numbers of both.
import { followKeys, motionChoice, runClock, scenarioChoice, transport, viewOptions } from "./controls.js";
import { card, chip, element, pageHead, table } from "./dom.js";
import { rateCell, together } from "./rates.js";
import { fullScreenButton, pictureButton } from "./share.js";
import { atFirst, openView } from "./stage.js";
import { duration, store } from "./state.js";
import { themeButton } from "./theme.js";
import { hardContact, numbers, ratesOf, standing } from "./verdict.js";
import { degrees, millimetres, newtons, short } from "./words.js";

export function besidePage(root, { names, plans }) {
  const stores = plans.map((data) => store(atFirst(data)));
  const ends = () => plans.map(({ motions }, index) => duration(motions[stores[index].values.motion]));
  const shown = sharedTime(stores, ends);
  const pair = element("div", { class: "pair" });
  const end = () => Math.max(...ends());
  const both = element("section", { class: "both", "aria-label": "Motions" });
  both.append(element("div", { class: "stage shared" }, transport(shown, end), fullScreenButton(both) ?? ""), pair);
  root.append(
    pageHead(plans[0].result.scene, "", ["two plans of the same parts", ...names], themeButton()),
    element("main", {}, both, comparison(names, plans)),
  );
  const views = plans.map((data, index) => openStage(pair, names[index], data, plans, stores[index]));
  lookTogether(views);
  runClock(shown, end);
  followKeys(shown, end, () => plans[0].motions[stores[0].values.motion].time_step);
}

/** The time of both plans. A motion that ends earlier rests at its end. */
function sharedTime(stores, ends) {
  const shown = store({ time: 0, playing: false, speed: 1, motion: "" });
  const own = (index) => Math.min(shown.values.time, ends()[index]);
  stores.forEach((one, index) => {
    one.on(["motion"], () => shown.set({ motion: stores.map(({ values }) => values.motion).join() }));
    one.on(["time"], ({ time }) => time !== own(index) && shown.set({ time }));
  });
  shown.on(["time", "playing"], ({ playing }) => stores.forEach((one, index) => one.set({ time: own(index), playing })));
  return shown;
}

/** Where one view looks from, the other does. */
function lookTogether(views) {
  // The other view tells that it has moved, too.
  let isFollowing = false;
  const follow = (other, viewpoint) => {
    if (isFollowing) return;
    isFollowing = true;
    other?.lookFrom(viewpoint);
    isFollowing = false;
  };
  views.forEach((view, index) => view?.onMove((viewpoint) => follow(views[1 - index], viewpoint)));
}

/** A plan's view, which has room for both, and what can be chosen there. */
function openStage(pair, name, data, plans, shown) {
  const title = element("h2", {}, name, " ", chip(data.result.status, standing(data.result)));
  const stage = element("section", { class: "stage", "aria-label": `Motion of ${name}` }, title);
  pair.append(stage);
  const { choices, drawer } = motionChoice(data, shown);
  const view = openView(stage, data, shown, { plans, share: (own) => [pictureButton(own, data, shown)] });
  stage.append(choices, scenarioChoice(data, shown), viewOptions(data, shown), drawer);
  return view;
}

/** One row per number, one column per plan. */
function comparison(names, plans) {
  const rows = [
    ["status", plans.map(({ result }) => chip(result.status, standing(result)))],
    ...frictions(plans).flatMap((friction) => atFriction(plans, friction)),
    ...ofBoth(plans.map(numbers)),
    ...ofBoth(plans.map((data) => data.made_from)).filter(([, [one, other]]) => one !== other),
  ];
  return card(
    "Both plans",
    element("p", {}, "Rollouts with hard contact: the share of those with random errors that end at the goal, with Wilson's interval of 95 %, and the planned offsets. Below are the numbers that matter for execution, and what the plans were made from where that differs."),
    table("Both plans", ["number", ...names], rows.map(([name, cells]) => ({ cells: [name, ...cells] }))),
  );
}

const frictions = (plans) => [...new Set(plans.flatMap(({ motions }) => hardContact(motions).map(({ friction }) => friction)))];

/** What rollouts at a friction show. */
function atFriction(plans, friction) {
  const played = plans.map(({ motions }) => hardContact(motions).find((motion) => motion.friction === friction)?.scenarios ?? []);
  const rates = plans.map(({ result }) => ratesOf(result).filter((group) => group.friction === friction));
  const of = (inWords) => played.map((scenarios) => (scenarios.length === 0 ? "–" : inWords(scenarios)));
  const largest = (scenarios, number) => Math.max(...scenarios.map(number));
  const name = (what) => `${what}, friction ${short(friction)}`;
  return [
    [name("success"), rates.map((groups) => rateCell(together(groups)))],
    [name("planned offsets at the goal"), of((all) => `${all.filter(({ success }) => success).length} of ${all.length}`)],
    [name("end at most"), of((all) => `${millimetres(largest(all, ({ errors }) => errors[0]))}, ${degrees(largest(all, ({ errors }) => errors[1]))}`)],
    [name("largest force"), of((all) => newtons(largest(all, ({ max_force: force }) => force)))],
  ];
}

/** Names and values of two lists as rows; a dash where one of them has no such value. */
function ofBoth(lists) {
  const names = [...new Set(lists.flatMap((list) => list.map(([name]) => name)))];
  return names.map((name) => [name, lists.map((list) => list.find(([own]) => own === name)?.[1] ?? "–")]);
}
