//! Circular uses among neighbouring files and folders. A folder and its own files may use each other: they are one idea.

use std::collections::{BTreeMap, BTreeSet};

use super::source::Source;

/// Circles that remain: each is one idea in several files, or has an item in the wrong file.
pub(crate) const REMAINING: &[&str] = &[];

type Graph = BTreeMap<String, BTreeSet<String>>;

/// The folder and the members of each circle, in alphabetical order.
pub(crate) fn circles(source: &Source) -> Vec<(String, Vec<String>)> {
    let mut folders: BTreeMap<Vec<String>, Graph> = BTreeMap::new();
    for (from, to) in source.edges() {
        let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
        if let (Some(a), Some(b)) = (from.get(shared), to.get(shared)) {
            let graph = folders.entry(from[..shared].to_vec()).or_default();
            graph.entry(a.clone()).or_default().insert(b.clone());
        }
    }
    let named = |(folder, graph): (Vec<String>, Graph)| {
        of_graph(&graph).into_iter().map(move |circle| (folder.join("/"), circle)).collect::<Vec<_>>()
    };
    folders.into_iter().flat_map(named).collect()
}

/// Sets of nodes that can reach each other.
fn of_graph(graph: &Graph) -> BTreeSet<Vec<String>> {
    let reach: BTreeMap<&String, BTreeSet<&String>> =
        graph.keys().map(|node| (node, reached(graph, node))).collect();
    let mutual = |node: &String| -> Vec<String> {
        graph
            .keys()
            .filter(|other| reach[node].contains(other) && reach[*other].contains(node))
            .cloned()
            .collect()
    };
    graph.keys().map(mutual).filter(|circle| circle.len() > 1).collect()
}

fn reached<'a>(graph: &'a Graph, from: &'a str) -> BTreeSet<&'a String> {
    let (mut reached, mut waiting) = (BTreeSet::new(), vec![from]);
    while let Some(next) = waiting.pop() {
        waiting.extend(
            graph.get(next).into_iter().flatten().filter(|node| reached.insert(*node)).map(String::as_str),
        );
    }
    reached
}

#[test]
fn a_circle_is_found_and_a_line_is_none() {
    let graph = |edges: &[(&str, &str)]| {
        let mut graph = Graph::new();
        for (a, b) in edges {
            graph.entry((*a).to_owned()).or_default().insert((*b).to_owned());
        }
        of_graph(&graph)
    };
    assert!(graph(&[("a", "b"), ("b", "c"), ("a", "c")]).is_empty());
    let circle = ["b", "c"].map(str::to_owned).to_vec();
    assert_eq!(graph(&[("a", "b"), ("b", "c"), ("c", "b")]), BTreeSet::from([circle]));
}
