//! The part of the Khronos registry (gl.xml) that Tepui exports: features up to OpenGL 2.1 and extensions of that era.

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::{Document, Node};

use crate::selection::{EXTENSIONS, FEATURES};

/// A parameter of a command.
#[derive(Clone, Debug)]
pub struct Param {
    /// Its name.
    pub name: String,
    /// Its C type, as in `const GLfloat *`.
    pub ctype: String,
    /// The group of enums that its values come from.
    pub group: Option<String>,
}

/// A command.
#[derive(Clone, Debug)]
pub struct Command {
    /// As C spells it.
    pub name: String,
    /// C type of the result.
    pub result: String,
    /// In order.
    pub params: Vec<Param>,
    /// The command that this one is another spelling of.
    pub alias: Option<String>,
}

/// A version or an extension: what it adds.
#[derive(Clone, Debug)]
pub struct Group {
    /// `GL_VERSION_1_2`, `GL_EXT_texture3D`.
    pub name: String,
    /// Names of enums, in the registry's order.
    pub enums: Vec<String>,
    /// Names of commands, in the registry's order.
    pub commands: Vec<String>,
}

/// All that was selected.
pub struct Registry {
    /// Value of every enum of a group, as the registry writes it.
    pub enums: BTreeMap<String, String>,
    /// Every command of a group.
    pub commands: BTreeMap<String, Command>,
    /// Versions, then extensions.
    pub groups: Vec<Group>,
    /// Names of the enums that a parameter takes, by group.
    pub enum_groups: BTreeMap<String, Vec<String>>,
}

fn text(node: Node) -> String {
    node.descendants().filter(|n| n.is_text()).filter_map(|n| n.text()).collect()
}

fn child<'a, 'i>(node: Node<'a, 'i>, tag: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|n| n.has_tag_name(tag))
}

/// Splits `const <ptype>GLfloat</ptype> *<name>v</name>` into type and name.
fn declaration(node: Node) -> Param {
    let name = child(node, "name").map(text).unwrap_or_default();
    let mut ctype = String::new();
    for n in node.descendants().filter(|n| n.is_text()) {
        if !n.ancestors().any(|a| a.has_tag_name("name")) {
            ctype.push_str(n.text().unwrap_or(""));
        }
    }
    let group = node.attribute("group").map(str::to_string);
    Param { name, ctype: ctype.split_whitespace().collect::<Vec<_>>().join(" "), group }
}

fn group(node: Node, name: &str) -> Group {
    let mut group = Group { name: name.to_string(), enums: Vec::new(), commands: Vec::new() };
    let desktop = |n: &Node| n.attribute("api").is_none_or(|api| api == "gl") && n.attribute("profile") != Some("core");
    for require in node.children().filter(|n| n.has_tag_name("require") && desktop(n)) {
        for item in require.children().filter(Node::is_element) {
            let name = item.attribute("name").unwrap_or_default().to_string();
            match item.tag_name().name() {
                "enum" => group.enums.push(name),
                "command" => group.commands.push(name),
                _ => {}
            }
        }
    }
    group
}

impl Registry {
    /// Reads the registry that the crate `khronos_api` carries.
    pub fn read() -> Registry {
        let xml = std::str::from_utf8(khronos_api::GL_XML).expect("gl.xml is UTF-8");
        let document = Document::parse(xml).expect("gl.xml is well-formed");
        let root = document.root_element();

        let mut groups = Vec::new();
        for (tag, wanted) in [("feature", FEATURES), ("extension", EXTENSIONS)] {
            for name in wanted {
                let node = root.descendants().find(|n| n.has_tag_name(tag) && n.attribute("name") == Some(name));
                groups.push(group(node.unwrap_or_else(|| panic!("{name} is not in the registry")), name));
            }
        }
        let enum_names: BTreeSet<&str> = groups.iter().flat_map(|g| g.enums.iter().map(String::as_str)).collect();
        let command_names: BTreeSet<&str> = groups.iter().flat_map(|g| g.commands.iter().map(String::as_str)).collect();

        let mut enums = BTreeMap::new();
        for node in root.children().filter(|n| n.has_tag_name("enums")).flat_map(|n| n.children()).filter(|n| n.has_tag_name("enum")) {
            let (Some(name), Some(value)) = (node.attribute("name"), node.attribute("value")) else { continue };
            if enum_names.contains(name) && node.attribute("api").is_none_or(|api| api == "gl") {
                enums.insert(name.to_string(), value.to_string());
            }
        }
        let mut commands = BTreeMap::new();
        for node in root.children().filter(|n| n.has_tag_name("commands")).flat_map(|n| n.children()).filter(|n| n.has_tag_name("command"))
        {
            let Some(proto) = child(node, "proto").map(declaration) else { continue };
            if command_names.contains(proto.name.as_str()) {
                let params = node.children().filter(|n| n.has_tag_name("param")).map(declaration).collect();
                let alias = child(node, "alias").and_then(|n| n.attribute("name")).map(str::to_string);
                commands.insert(proto.name.clone(), Command { name: proto.name, result: proto.ctype, params, alias });
            }
        }
        let mut enum_groups = BTreeMap::new();
        for node in root.children().filter(|n| n.has_tag_name("groups")).flat_map(|n| n.children()).filter(|n| n.has_tag_name("group")) {
            let names = node.children().filter_map(|n| n.attribute("name")).filter(|name| enums.contains_key(*name));
            enum_groups.insert(node.attribute("name").unwrap_or_default().to_string(), names.map(str::to_string).collect::<Vec<_>>());
        }
        Registry { enums, commands, groups, enum_groups }
    }

    /// Names of the commands of the versions up to `GL_VERSION_1_1`.
    pub fn gl11(&self) -> Vec<&str> {
        self.groups[..2].iter().flat_map(|g| g.commands.iter().map(String::as_str)).collect()
    }
}
