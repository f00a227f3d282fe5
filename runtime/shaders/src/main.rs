//! Writes every translation of the shaders.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for file in nearfield_shaders::generate()? {
        if let Some(folder) = file.path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        std::fs::write(&file.path, &file.contents)?;
        println!("{}", file.path.display());
    }
    Ok(())
}
