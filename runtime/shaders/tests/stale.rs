//! The committed translations are those of the source.

#[test]
fn translations_are_not_stale() {
    for file in nearfield_shaders::generate().expect("valid shaders") {
        let committed = std::fs::read(&file.path).unwrap_or_default();
        let path = file.path.display();
        assert!(committed == file.contents, "{path} is stale: write it again with `cargo run` in runtime/shaders");
    }
}
