// Buttons that take the view elsewhere: a picture, the full screen, a link to the moment.
import { element } from "./dom.js";
import { fragmentOf, momentOf } from "./link.js";

/** How long (ms) a sentence about what a button did is shown. */
const SHOWN = 4000;

/** The buttons, and where they say what they did. */
export function shareButtons(stage, view, data, shown) {
  const said = element("output", { class: "said" });
  const say = (words) => {
    said.textContent = words;
    setTimeout(() => (said.textContent = ""), SHOWN);
  };
  const button = (name, explanation, click) => element("button", { type: "button", title: explanation, click }, name);
  const buttons = element(
    "div",
    { class: "views share", role: "group", "aria-label": "Share" },
    button("Picture", "Save the view as a PNG", () => savePicture(view, data, shown)),
    document.fullscreenEnabled ? fullScreenButton(stage) : null,
    // Within a notebook, the page has no address.
    location.protocol === "about:" ? null : button("Link", "Copy a link to this moment", () => copyLink(view, shown, say)),
  );
  return { buttons, said };
}

function savePicture(view, { result }, shown) {
  const name = `${result.scene}-${shown.values.time.toFixed(2)}s.png`;
  view.picture((picture) => {
    const address = URL.createObjectURL(picture);
    element("a", { href: address, download: name }).click();
    URL.revokeObjectURL(address);
  });
}

function fullScreenButton(stage) {
  const isFull = () => document.fullscreenElement === stage;
  const button = element("button", { type: "button", click: () => (isFull() ? document.exitFullscreen() : stage.requestFullscreen()) });
  const name = () => (button.textContent = isFull() ? "Leave full screen" : "Full screen");
  document.addEventListener("fullscreenchange", name);
  name();
  return button;
}

async function copyLink(view, shown, say) {
  shown.set({ playing: false });
  // The address is the link also where a page may not write to the clipboard.
  location.replace(fragmentOf(shown.values, view.viewpoint()));
  try {
    await navigator.clipboard.writeText(location.href);
    say("Link copied");
  } catch {
    say("The address of this window is the link");
  }
}

/** Shows the moment that the address names, now and whenever it changes; the plots do so without a view, too. */
export function followAddress(stage, view, { motions }, shown) {
  const follow = () => {
    const moment = momentOf(location.hash, motions, shown.values);
    if (moment === null) return;
    shown.set(moment.values);
    if (moment.viewpoint !== null) view?.lookFrom(moment.viewpoint);
    stage.scrollIntoView({ block: "nearest" });
  };
  addEventListener("hashchange", follow);
  follow();
}
