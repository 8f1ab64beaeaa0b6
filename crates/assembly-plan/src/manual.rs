//! `man`: the manual pages.

use std::fs::create_dir_all;
use std::io;
use std::path::Path;

use clap::{Arg, Command};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, italic, roman};
use planner::files::{require_folder, write_file};

use crate::arguments::{CLOSINGS, Closing, ManualArguments, command_line};
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the pages of the program and of every command.
pub fn run(arguments: &ManualArguments) -> Result<Exit, CommandError> {
    let folder = &arguments.folder;
    let mut program = command_line().disable_help_subcommand(true);
    program.build();
    require_folder(folder)?;
    create_dir_all(folder).and_then(|()| write_pages(&program, folder)).map_err(|error| {
        CommandError::System(format!("{}: the manual cannot be written: {error}", folder.display()))
    })?;
    say!("written to {}", folder.display());
    Ok(Exit::Done)
}

/// Writes the page of a command and those of its subcommands.
fn write_pages(command: &Command, folder: &Path) -> io::Result<()> {
    command.get_subcommands().filter(|command| !command.is_hide_set()).try_for_each(|it| write_pages(it, folder))?;
    write_page(command, folder)
}

fn write_page(command: &Command, folder: &Path) -> io::Result<()> {
    let name = command.get_bin_name().unwrap_or_default();
    // A step of a command ends like the command.
    let closing = name.split(' ').nth(1).map_or_else(|| Closing::of(""), Closing::of);
    let mut shown = command.clone().override_usage(synopsis(command));
    if let Some(closing) = closing.filter(|closing| name.ends_with(closing.command) && !closing.description.is_empty())
    {
        shown = shown.long_about(closing.description);
    }
    let page = Man::new(shown)
        .manual("assembly-plan")
        // None, but an empty one would be left out and shift what follows.
        .date(" ")
        .source(format!("assembly-plan {}", command.get_version().unwrap_or_default()));
    let mut text = Vec::new();
    page.render_title(&mut text)?;
    page.render_name_section(&mut text)?;
    page.render_synopsis_section(&mut text)?;
    page.render_description_section(&mut text)?;
    page.render_options_section(&mut text)?;
    if command.has_subcommands() {
        page.render_subcommands_section(&mut text)?;
    }
    closing.map_or(Ok(()), |closing| closing_sections(closing, name).to_writer(&mut text))?;
    page.render_version_section(&mut text)?;
    write_file(&folder.join(page.get_filename()), &text).map_err(io::Error::other)
}

/// How a command is called, with the values of its flags.
fn synopsis(command: &Command) -> String {
    let shown: Vec<&Arg> = command.get_arguments().filter(|argument| !argument.is_hide_set()).collect();
    let words = |argument: &&Arg| {
        let names = argument.get_value_names().unwrap_or_default().join(" ");
        let word = match argument.get_long() {
            Some(flag) if argument.get_action().takes_values() => format!("--{flag} {names}"),
            Some(flag) => format!("--{flag}"),
            None => names,
        };
        if argument.is_required_set() { word } else { format!("[{word}]") }
    };
    let (positional, flags): (Vec<&Arg>, Vec<&Arg>) = shown.into_iter().partition(|argument| argument.is_positional());
    let step = command.has_subcommands().then(|| "COMMAND".to_owned());
    let name = command.get_bin_name().unwrap_or_default().to_owned();
    let all = [name].into_iter().chain(flags.iter().map(words)).chain(positional.iter().map(words)).chain(step);
    all.collect::<Vec<_>>().join(" ")
}

/// The last sections of a page.
fn closing_sections(closing: &Closing, name: &str) -> Roff {
    let mut page = Roff::new();
    page.control("SH", ["EXIT STATUS"]);
    for (code, meaning) in closing.exit_codes() {
        page.control("TP", []).text([bold(code.to_string())]).text([roman(meaning)]);
    }
    page.control("SH", ["EXAMPLES"]);
    for (arguments, purpose) in closing.examples {
        page.control("TP", []).text([bold(format!("assembly-plan {arguments}"))]).text([roman(*purpose)]);
    }
    if !closing.files.is_empty() {
        page.control("SH", ["FILES"]);
        for (file, meaning) in closing.files {
            page.control("TP", []).text([italic(*file)]).text([roman(*meaning)]);
        }
    }
    page.control("SH", ["SEE ALSO"]);
    let pages = CLOSINGS.iter().map(|closing| match closing.command {
        "" => "assembly-plan".to_owned(),
        command => format!("assembly-plan-{command}"),
    });
    let others: Vec<String> =
        pages.filter(|page| *page != name.replace(' ', "-")).map(|page| format!("{page}(1)")).collect();
    page.text([roman(others.join(", "))]);
    page
}
