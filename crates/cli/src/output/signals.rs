//! Signals that terminate the program.

use eigenshade_model::unfinished;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

/// Installs a handler: SIGINT and SIGTERM then remove the files being written and terminate the
/// program as they do by default.
///
/// Where signals cannot be caught, such files are left behind.
pub fn clean_up_on_end() {
    let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else { return };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            unfinished::remove_all();
            let _ = emulate_default_handler(signal);
            std::process::exit(128 + signal);
        }
    });
}
