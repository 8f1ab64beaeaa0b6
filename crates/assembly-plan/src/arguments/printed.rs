//! What the user can have printed of the program itself: schemas, completions, manual pages.

use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// Print the schema of homotopy files
    #[arg(long)]
    pub homotopy: bool,
}

#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell that reads the script
    pub shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub struct ManualArguments {
    /// Folder to write them to, one file for the program and one for each command
    pub folder: PathBuf,
}
