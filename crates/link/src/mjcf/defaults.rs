//! Values that an element takes from its class of defaults.

use roxmltree::Node;

use crate::element::{Value, attribute, children, tag};
use crate::error::ModelError;

/// An element with its defaults: its class, the class around that, and so on.
pub struct Levels<'text> {
    elements: Vec<Node<'text, 'text>>,
}

impl<'text> Levels<'text> {
    /// For an element, whose class is its own or that of the nearest body or frame with one for its children.
    ///
    /// # Errors
    /// When there is no such class.
    pub fn of(element: Node<'text, 'text>) -> Result<Self, ModelError> {
        let of_parents = || element.ancestors().skip(1).find_map(|around| attribute(around, "childclass"));
        let class = attribute(element, "class").or_else(of_parents);
        let root = element.document().root_element();
        let mut all = children(root, "default").flat_map(|outermost| outermost.descendants());
        let mut classes: Vec<Node> = Vec::new();
        // `main` is the class of what stands at the top.
        if let Some(class) = class.filter(|class| class.text != "main") {
            let is_named = |node: &Node| node.has_tag_name("default") && node.attribute("class") == Some(class.text);
            let Some(innermost) = all.find(is_named) else {
                return Err(class.refuse("is not a class of <default>"));
            };
            classes.extend(innermost.ancestors().filter(|node| node.has_tag_name("default")));
        }
        classes.extend(children(root, "default"));
        let of_classes = classes.into_iter().flat_map(|class| children(class, tag(element)));
        Ok(Self { elements: std::iter::once(element).chain(of_classes).collect() })
    }

    /// For an element that has no defaults.
    pub fn alone(element: Node<'text, 'text>) -> Self {
        Self { elements: vec![element] }
    }

    /// The attribute of a name on the first level that has it.
    pub fn attribute(&self, name: &str) -> Option<Value<'text>> {
        self.first(&[name]).map(|(_, value)| value)
    }

    /// The first of these attributes on the first level that has any, and its place in the list.
    pub fn first(&self, names: &[&str]) -> Option<(usize, Value<'text>)> {
        let of_element = |element: &Node<'text, 'text>| {
            let mut values = names.iter().enumerate();
            values.find_map(|(place, name)| Some((place, attribute(*element, name)?)))
        };
        self.elements.iter().find_map(of_element)
    }

    /// As [`first`](Self::first), for alternative attributes.
    ///
    /// # Errors
    /// When an element has two of them.
    pub fn one_of(&self, names: &[&str]) -> Result<Option<(usize, Value<'text>)>, ModelError> {
        for element in &self.elements {
            let mut values = names.iter().filter_map(|name| attribute(*element, name));
            if let (Some(_), Some(second)) = (values.next(), values.next()) {
                return Err(second.refuse("is a second orientation: state one"));
            }
        }
        Ok(self.first(names))
    }
}
