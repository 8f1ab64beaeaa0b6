//! A film as one SVG file: every picture is a group, and a style sheet shows one after the other. Browsers play it, also where it
//! is an image of another page; other programs, and readers who have asked for less motion, see the end.

use std::fmt::Write;

use super::film::{Film, Item, Outline, Picture, REST, Shape};
use super::outline::Point;
use crate::figures::{BEGIN, Hex};
use crate::html::escaped;

/// How much longer (s) than its time a picture is shown, below the next one: no instant is without one.
const LONGER: f64 = 0.004;

/// Whether a file is a drawing of ours.
pub fn is_own(content: &[u8]) -> bool {
    content.starts_with(BEGIN.as_bytes())
}

/// The text of the file, titled with the name of the scene.
pub fn write(film: &Film, scene: &str) -> String {
    let [width, height] = film.size;
    let last = film.pictures.len() - 1;
    let total = last as f64 * film.interval + REST;
    let share = |time: f64| 100.0 * (time + LONGER).min(total) / total;
    let mut text = format!(
        "{BEGIN}<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <title>Motion of {}</title>\n<style>\n\
         .shape{{stroke-width:.7;stroke-linejoin:round}}\n.line{{fill:none;stroke-width:1.6;stroke-linejoin:round}}\n\
         .dashed{{stroke-width:1.2;stroke-dasharray:5 4}}\n.picture{{animation:picture {total:.2}s step-end infinite}}\n\
         .end{{animation-name:end}}\n@keyframes picture{{0%{{visibility:visible}}{:.3}%{{visibility:hidden}}}}\n\
         @keyframes end{{0%{{visibility:visible}}{:.3}%{{visibility:hidden}}}}\n\
         @media (prefers-reduced-motion:reduce){{.picture{{animation:none}}}}\n</style>\n<defs>\n\
         <rect id=\"ground\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n",
        escaped(scene),
        share(film.interval),
        share(REST),
    );
    for (index, shapes) in film.fixed.iter().enumerate() {
        push(&mut text, format_args!("<g id=\"part{index}\" class=\"shape\">"));
        shapes.iter().for_each(|shape| polygon(&mut text, shape));
        text.push_str("</g>\n");
    }
    text.push_str("</defs>\n");
    for (index, picture) in film.pictures.iter().enumerate() {
        let (class, seen) = if index == last { ("picture end", "visible") } else { ("picture", "hidden") };
        // All have begun: a picture whose turn is still to come is hidden.
        let delay = index as f64 * film.interval - total;
        push(
            &mut text,
            format_args!(
                "<g class=\"{class}\" visibility=\"{seen}\" style=\"animation-delay:{delay:.2}s\"><use href=\"#ground\"/>"
            ),
        );
        draw(&mut text, picture, film.size);
        text.push_str("</g>\n");
    }
    text.push_str("</svg>\n");
    text
}

/// A string takes everything.
fn push(text: &mut String, words: std::fmt::Arguments) {
    let _ = text.write_fmt(words);
}

fn draw(text: &mut String, picture: &Picture, [width, height]: [f64; 2]) {
    for item in &picture.items {
        match item {
            Item::Fixed(index) => push(text, format_args!("<use href=\"#part{index}\"/>")),
            Item::Moving(shapes) => {
                text.push_str("<g class=\"shape\">");
                shapes.iter().for_each(|shape| polygon(text, shape));
                text.push_str("</g>");
            }
        }
    }
    picture.outlines.iter().for_each(|outline| lines(text, outline));
    let done = picture.share * width;
    push(text, format_args!("<rect y=\"{}\" width=\"{done:.1}\" height=\"3\" fill=\"#596579\"/>", height - 3.0));
}

fn polygon(text: &mut String, shape: &Shape) {
    let colour = Hex(shape.colour);
    push(text, format_args!("<path fill=\"{colour}\" stroke=\"{colour}\" d=\"{}Z\"/>", Path(&shape.corners)));
}

fn lines(text: &mut String, outline: &Outline) {
    let class = if outline.dashed { "line dashed" } else { "line" };
    push(text, format_args!("<path class=\"{class}\" stroke=\"{}\" d=\"", Hex(outline.colour)));
    outline.lines.iter().for_each(|line| push(text, format_args!("{}", Path(line))));
    text.push_str("\"/>");
}

/// A line through points as SVG writes it.
struct Path<'a>(&'a [Point]);

impl std::fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        for (index, [x, y]) in self.0.iter().enumerate() {
            write!(f, "{}{x:.1} {y:.1}", ["L", "M"][usize::from(index == 0)])?;
        }
        Ok(())
    }
}
