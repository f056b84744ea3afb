//! The code in a document.

pub fn blocks(document: &str, language: &str) -> Vec<String> {
    let blocks = document.split("\n```").skip(1).step_by(2);
    blocks.filter_map(|block| block.strip_prefix(&format!("{language}\n"))).map(|code| format!("{code}\n")).collect()
}
