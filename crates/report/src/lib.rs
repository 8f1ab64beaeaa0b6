//! Pages, figures and animations of plans, batches, simulations and tolerances.
//!
//! A folder is read ([`read()`]) into the data of a page ([`PageData`]), and the page is that data as JSON, a script and a
//! style sheet in one HTML file ([`html`]) that needs no network. What the folder lacks is computed while
//! it is read: where parts touch, rollouts with hard contact, the joints of the arm. Logs of robots are shown beside rollouts.
//! [`figures`] draws the same data as SVG files for papers and slides, [`animation`] as moving pictures.
//!
//! | module | content |
//! |---|---|
//! | [`model`] | the data of a page |
//! | `read` | from a folder to that data |
//! | [`html`] | from that data to an HTML file |
//! | [`figures`] | from that data to SVG files |
//! | [`animation`] | from the data of a plan to an SVG or GIF file that moves |
//!
//! The script is made of the modules in `page/` and of three.js and uPlot. `scripts/vendor-page` bundles them into the
//! files of `page/bundle`, which are checked in: building this crate needs no Node.

pub mod animation;
pub mod figures;
pub mod html;
pub mod model;
mod read;
mod rounded;
mod write;

pub use animation::Animation;
pub use html::PAGE;
pub use model::PageData;
pub use read::read;
pub use write::{Request, Written, require_writable, write};
