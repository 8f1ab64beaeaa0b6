// The state of the page, and listeners for its changes.

/** A store of values; listeners are called with all values when one of their names changes. */
export function store(values) {
  const listeners = [];
  return {
    values,
    set(changes) {
      const changed = Object.keys(changes).filter((key) => values[key] !== changes[key]);
      if (changed.length === 0) return;
      Object.assign(values, changes);
      listeners.filter(({ keys }) => keys.some((key) => changed.includes(key))).forEach(({ listener }) => listener(values));
    },
    on(keys, listener) {
      listeners.push({ keys, listener });
      listener(values);
    },
  };
}

/** Time (s) from the first to the last knot of a motion. */
export const duration = (motion) => motion.time_step * (motion.reference.length / 7 - 1);
