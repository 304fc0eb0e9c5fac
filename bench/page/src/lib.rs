//! The page of a running bench: the panel, the vehicle around it, the bus, in a browser.
//!
//! [`Session`] owns one bench and is driven from outside: [`Session::take`] obeys a page, [`Session::turn`] lets time
//! pass, and what the pages are to be told comes back as [`Update`]s. `catalog` is what there is to change and to read,
//! `live` what is told while it runs, `pace` how virtual time follows the wall clock, `trace` the bus, `recording` what
//! is kept, `scenes` stories that play. The page itself is text without a build step: `page.html`, `page.css`,
//! `page.js`, and a link to the session, over a socket of this machine or to a Worker of the browser ([`Link`]).
//!
//! No path, no clock, no thread, no socket: the same code runs on a PC (crate `bench-host`) and in a browser (crate
//! `bench-web`).

#![forbid(unsafe_code)]

mod beside;
mod catalog;
mod live;
mod pace;
mod recording;
mod scenes;
mod session;
mod trace;
mod wires;

pub use recording::{Length, Recording, png};
pub use scenes::{Judge, Library, Text, Trial};
pub use session::{Beginning, Clock, Command, Make, Session, Tell, Update};
pub use trace::decode_to_json;

/// How the page reaches its session.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// A web socket of the server that sent the page.
    Socket,
    /// A Worker of the same browser.
    Worker,
}

/// Returns the page: markup, style, link and script are files in the source and one text for the browser.
pub fn html(link: Link) -> String {
    let link = match link {
        Link::Socket => include_str!("link-socket.js"),
        Link::Worker => include_str!("link-worker.js"),
    };
    include_str!("page.html")
        .replace("/* page.css */", include_str!("page.css"))
        .replace("/* link.js */", link)
        .replace("/* page.js */", include_str!("page.js"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_whole_and_names_no_other_host() {
        for link in [Link::Socket, Link::Worker] {
            let page = html(link);
            assert!(!page.contains("/* page.") && !page.contains("/* link."), "all of it is in it");
            for (at, _) in page.match_indices("://") {
                let around = &page[at.saturating_sub(5)..at + 3];
                assert!(around.ends_with("ws://") || page[at..].starts_with("://www.w3.org/"), "{around}");
            }
        }
    }
}
