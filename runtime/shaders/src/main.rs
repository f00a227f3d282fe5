//! Writes every translation of the shaders; with `--check`, fails if one is not what it would write.

use nearfield_shaders::generate;
use std::error::Error;
use std::fs;

fn main() -> Result<(), Box<dyn Error>> {
    let is_check = std::env::args().nth(1).as_deref() == Some("--check");
    for file in generate()? {
        let path = file.path.display();
        if is_check {
            if fs::read(&file.path).unwrap_or_default() != file.contents {
                return Err(format!("{path} is stale: write it again with `cargo run` in runtime/shaders").into());
            }
            continue;
        }
        if let Some(folder) = file.path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&file.path, &file.contents)?;
        println!("{path}");
    }
    Ok(())
}
