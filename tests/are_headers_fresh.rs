//! Are the committed headers what cbindgen makes of `src/capi` today?
//!
//! `UPDATE_HEADERS=1 cargo test --test are_headers_fresh` rewrites them.

use cbindgen::{Builder, Config, DocumentationStyle, ItemType, Language, Style};
use std::fs;
use std::path::Path;
use support::Family;

#[test]
fn liba_headers_are_fresh() {
    for name in Family::ALL.map(Family::c_name) {
        let path = format!("include/a/{name}.h");
        check_fresh(&path, &liba_header(name));
    }
}

#[test]
fn claraty_header_is_fresh() {
    let mut fresh = Vec::new();
    Builder::new()
        .with_config(Config::from_file("cbindgen/claraty.toml").unwrap())
        .with_src("src/capi/claraty.rs")
        .generate()
        .unwrap()
        .write(&mut fresh);
    // C++98 has no comma at the end of an enumeration.
    let fresh = String::from_utf8(fresh).unwrap().replace(",\n} ", "\n} ");
    let fresh = format!("{}\n", fresh.trim()).replace("*/\n\n\n", "*/\n\n");
    check_fresh("include/claraty/trapezoid.h", &fresh);
}

#[test]
fn atraj_header_is_fresh() {
    check_fresh("include/atraj.h", &atraj_header());
}

fn atraj_header() -> String {
    let config = config("atraj");
    let about = config.header.clone().unwrap_or_default();
    let includes = Family::ALL
        .map(Family::c_name)
        .map(|name| format!("#include \"a/{name}.h\""))
        .join("\n");
    let functions = pass("atraj", &config, ItemType::Functions);
    format!(
        "{about}
#ifndef ATRAJ_H
#define ATRAJ_H

{includes}

#if defined(__cplusplus)
extern \"C\" {{
#endif /* __cplusplus */

{functions}

#if defined(__cplusplus)
}} /* extern \"C\" */
#endif /* __cplusplus */

#endif /* ATRAJ_H */
"
    )
    .trim_start()
    .to_owned()
}

/// The C++ methods in a struct call the functions, so the functions come first. cbindgen runs once for the functions and
/// once for the structs.
fn liba_header(name: &str) -> String {
    let guard = format!("LIBA_{}_H", name.to_uppercase());
    let config = config(name);
    let about = config.header.clone().unwrap_or_default();
    let functions = pass(name, &config, ItemType::Functions);
    let structs = pass(name, &config, ItemType::Structs);
    let levels = levels(name);
    format!(
        "{about}
#ifndef {guard}
#define {guard}

#include \"a.h\"
{levels}
typedef struct a_{name} a_{name};

#if defined(__cplusplus)
extern \"C\" {{
#endif /* __cplusplus */

{functions}

#if defined(__cplusplus)
}} /* extern \"C\" */
namespace a
{{
typedef struct a_{name} {name};
}} /* namespace a */
#endif /* __cplusplus */

{structs}

#endif /* {guard} */
"
    )
    .trim_start()
    .to_owned()
}

/// What a polynomial header says of the arrays in its struct. Other headers say nothing.
fn levels(name: &str) -> String {
    let highest = match name {
        "trajpoly3" | "trajpoly5" => 3,
        "trajpoly7" => 4,
        _ => return String::new(),
    };
    let level = format!("A_{}", name.to_uppercase());
    let built = format!("ATRAJ_{}", name.to_uppercase());
    format!(
        "
/*! How many of the coefficient arrays p v a j the struct holds: 1 .. {highest}. It must be what the archive was built with. */
#if !defined({level})
#if defined({built})
#define {level} {built}
#else
#define {level} {highest}
#endif
#endif
#if ({level} + 0 < 1) || ({level} + 0 > {highest})
#error \"{level} does not exist at this level: define it as 1 .. {highest} or leave it undefined.\"
#endif
#if defined(A_TRAJPOLY_COMPACT) && ({level} + 0 != {highest})
#error \"The structs of A_TRAJPOLY_COMPACT have no levels: leave {level} undefined.\"
#endif
#if defined({built}) && ({level} + 0 != {built})
#error \"{level} differs from the archive beside this header: rebuild it with {level}=... make dist, or leave it undefined.\"
#endif
"
    )
}

fn config(name: &str) -> Config {
    let mut config = Config::from_file(format!("cbindgen/{name}.toml")).unwrap();
    config.language = Language::C;
    config.style = Style::Tag;
    config.documentation_style = DocumentationStyle::Doxy;
    config.no_includes = true;
    config.usize_is_size_t = true;
    config.line_length = 120;
    config.tab_width = 4;
    config.function.prefix = Some("A_EXTERN".into());
    for array in ["v", "a", "j"] {
        config
            .defines
            .insert(format!("{name}_{array}"), format!("{name}_{array}"));
    }
    config
        .defines
        .insert("feature = poly-compact".into(), "A_TRAJPOLY_COMPACT".into());
    config
}

fn pass(name: &str, config: &Config, items: ItemType) -> String {
    let mut config = config.clone();
    config.header = None;
    config.export.item_types = vec![items];
    let mut text = Vec::new();
    Builder::new()
        .with_config(config)
        .with_src(format!("src/capi/{name}.rs"))
        .generate()
        .unwrap()
        .write(&mut text);
    let text = String::from_utf8(text).unwrap();
    // cbindgen puts the `;` of a conditional field behind its `#endif`, and writes no condition but `defined`.
    let mut text = text.replace("\n#endif\n    ;\n", ";\n#endif\n");
    for (level, array) in ["v", "a", "j"].iter().enumerate() {
        let condition = format!("A_{} + 0 > {}", name.to_uppercase(), level + 1);
        text = text.replace(&format!("defined({name}_{array})"), &condition);
    }
    text.trim().to_owned()
}

fn check_fresh(path: &str, fresh: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    if std::env::var_os("UPDATE_HEADERS").is_some() {
        fs::write(&path, fresh).unwrap();
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        committed == fresh,
        "{} is stale: run `UPDATE_HEADERS=1 cargo test --test are_headers_fresh`",
        path.display()
    );
}
