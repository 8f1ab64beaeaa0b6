//! The few elements of SVG that figures are made of.

use std::fmt::{self, Display, Formatter, Write};

use crate::html::escaped;

/// First line of figures; only a file with it is replaced.
pub const BEGIN: &str = "<!-- drawn by assembly-plan report -->\n";

/// Colours of scenarios, distinguishable also by people who are colour-blind (Okabe and Ito).
pub const COLOURS: [Colour; 6] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0xe6, 0x9f, 0x00],
    [0x56, 0xb4, 0xe9],
];

/// Red, green, blue.
pub type Colour = [u8; 3];

/// A colour as SVG writes it.
#[derive(Debug, Clone, Copy)]
pub struct Hex(pub Colour);

impl Display for Hex {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let [red, green, blue] = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

/// Where a text stands relative to its point.
#[derive(Debug, Clone, Copy)]
pub enum Anchor {
    /// To the right of it.
    Start,
    /// Around it.
    Middle,
    /// To the left of it.
    End,
}

/// A drawing that grows element by element; lengths are pixels, y points down.
#[derive(Debug)]
pub struct Drawing {
    size: [f64; 2],
    content: String,
}

impl Drawing {
    /// A white sheet.
    pub fn new(width: f64, height: f64) -> Self {
        Self { size: [width, height], content: String::new() }
    }

    /// A line of SVG.
    pub fn push(&mut self, element: &str) {
        self.content.push_str(element);
        self.content.push('\n');
    }

    /// A text of 12 pixels.
    pub fn text(&mut self, [x, y]: [f64; 2], anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let text = escaped(text);
        self.push(&format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>"));
    }

    /// A rectangle with attributes of its own.
    pub fn rectangle(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], style: &str) {
        let place = format!("x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"");
        self.push(&format!("<rect {place} {style}/>"));
    }

    /// A line through points, closed for a `polygon`.
    pub fn points(&mut self, element: &str, points: impl Iterator<Item = [f64; 2]>, style: &str) {
        let mut list = String::new();
        for [x, y] in points {
            // A string takes everything.
            let _ = write!(list, "{x:.1},{y:.1} ");
        }
        self.push(&format!("<{element} points=\"{}\" {style}/>", list.trim_end()));
    }

    /// The whole file.
    pub fn finish(self) -> String {
        let [width, height] = self.size;
        format!(
            "{BEGIN}<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{}</svg>\n",
            self.content
        )
    }
}
