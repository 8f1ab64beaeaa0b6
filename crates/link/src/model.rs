//! Models and their links.

use std::path::{Path, PathBuf};

use roxmltree::{Document, Node, ParsingOptions};

use crate::element::{refuse, tag};
use crate::error::ModelError;
use crate::mjcf;
use crate::sdf;
use crate::shape::LinkShape;
use crate::urdf;

/// Files with more XML nodes than this are refused, and links with more shapes.
const MOST_NODES: u32 = 1_000_000;
const MOST_SHAPES: usize = 1000;

/// A model file.
#[derive(Debug)]
pub struct Model<'text> {
    file: PathBuf,
    format: Format,
    document: Document<'text>,
}

#[derive(Debug, Clone, Copy)]
enum Format {
    Sdf,
    Urdf,
    Mjcf,
}

/// A link with collision shapes.
#[derive(Debug, Clone)]
pub struct Link<'model> {
    /// Its name; those of the models around it come before it in SDF: `model::link`.
    pub name: String,
    model: &'model Model<'model>,
    element: Node<'model, 'model>,
}

impl<'text> Model<'text> {
    /// Reads the text of an SDF, URDF or MJCF file. Names of mesh files are relative to `file`.
    ///
    /// # Errors
    /// When it is not well-formed XML or of no known format, or is not whole without other files or programs.
    pub fn parse(file: &Path, text: &'text str) -> Result<Self, ModelError> {
        let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
        let document = Document::parse_with_options(text, options).map_err(|error| not_well_formed(text, &error))?;
        let root = document.root_element();
        let format = match tag(root) {
            "sdf" => Format::Sdf,
            "robot" => Format::Urdf,
            "mujoco" => Format::Mjcf,
            _ => return Err(refuse(root, "is neither <sdf>, <robot> (URDF) nor <mujoco> (MJCF)")),
        };
        if let Some(xacro) = root.descendants().find(|node| node.tag_name().namespace().is_some_and(is_xacro)) {
            return Err(refuse(xacro, "xacro is not expanded here: run `xacro` and use the file that it writes"));
        }
        let include = root.descendants().find(|node| node.has_tag_name("include"));
        if let Some(include) = include {
            return Err(refuse(include, "<include> is not followed: name the included file itself, or merge both"));
        }
        Ok(Self { file: file.to_owned(), format, document })
    }

    /// The links that have collision shapes, in the order of the file.
    ///
    /// # Errors
    /// When an MJCF geom names a class of defaults that is not there.
    pub fn links(&self) -> Result<Vec<Link<'_>>, ModelError> {
        let root = self.document.root_element();
        let elements = match self.format {
            Format::Sdf => sdf::links(root),
            Format::Urdf => urdf::links(root),
            Format::Mjcf => mjcf::bodies(root)?,
        };
        Ok(elements.into_iter().map(|(name, element)| Link { name, model: self, element }).collect())
    }
}

impl Link<'_> {
    /// Its collision shapes in its frame.
    ///
    /// # Errors
    /// When one of them is of another kind than box, cylinder and mesh, or something about it is wrong.
    pub fn shapes(&self) -> Result<Vec<LinkShape>, ModelError> {
        let file = &self.model.file;
        let shapes = match self.model.format {
            Format::Sdf => sdf::shapes(self.element, file),
            Format::Urdf => urdf::shapes(self.element, file),
            Format::Mjcf => mjcf::shapes(self.element, file),
        }?;
        if shapes.len() > MOST_SHAPES {
            let count = shapes.len();
            return Err(refuse(self.element, format!("{count} collision shapes are too many: at most {MOST_SHAPES}")));
        }
        Ok(shapes)
    }
}

fn is_xacro(namespace: &str) -> bool {
    namespace.contains("xacro")
}

/// An error of the XML parser with its place.
fn not_well_formed(text: &str, error: &roxmltree::Error) -> ModelError {
    let position = error.pos();
    let lines = text.split_inclusive('\n').take(position.row as usize - 1);
    let start = lines.map(str::len).sum::<usize>() + position.col as usize - 1;
    ModelError::new(start..start + 1, format!("is not well-formed XML: {error}"))
}
