//! From the data of a page to one self-contained HTML file.

use plan::PlannerError;

use crate::model::PageData;

/// Name of a page in the folder that it shows.
pub const PAGE: &str = "report.html";
/// First lines of pages; only a file with them is replaced.
pub const BEGIN: &str = "<!doctype html>\n<!-- written by assembly-plan report -->\n";

const SCRIPT: &str = include_str!("../page/bundle/page.js");
const STYLE: &str = include_str!("../page/bundle/page.css");

/// The page of some data.
///
/// # Errors
/// When the data cannot be written as JSON, which no data of ours causes.
pub fn page(data: &PageData) -> Result<String, PlannerError> {
    let json = serde_json::to_string(data).map_err(|_| PlannerError::Internal("the data of a page"))?;
    let (title, version) = (escaped(&title(data)), env!("CARGO_PKG_VERSION"));
    let json = embedded(&json);
    Ok(format!(
        "{BEGIN}<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <meta name=\"generator\" content=\"assembly-plan {version}\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <noscript>This page needs JavaScript to show its plots and its 3D view.</noscript>\n\
         <div id=\"page\"></div>\n<script type=\"application/json\" id=\"data\">{json}</script>\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    ))
}

fn title(data: &PageData) -> String {
    match data {
        PageData::Plan(plan) => format!("{}, start {}", plan.result.scene, plan.result.start),
        PageData::Beside(beside) => format!("{}: {}", beside.plans[0].result.scene, beside.names.join(" and ")),
        PageData::Batch(batch) => format!("batch {}", batch.title),
        PageData::Simulation(simulation) => format!("simulation {}", simulation.title),
        PageData::Tolerance(tolerance) => format!("tolerances of {}", tolerance.record.scene),
    }
}

/// JSON that does not end the element it stands in, whatever names it holds.
fn embedded(json: &str) -> String {
    // Neither `</script>` nor `<!--` is left; JSON reads the escapes as the same letters.
    json.replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

/// Text without letters that mean something in HTML.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{BatchData, CellData};

    fn batch(title: &str) -> PageData {
        let cell = CellData {
            index: 0,
            scene: "</script><script>alert(1)</script>".to_owned(),
            start: "<!--".to_owned(),
            delta: 0.01,
            homotopy: None,
            state: "done",
            status: "done".to_owned(),
            page: None,
            errors: None,
            effort: None,
            rate: None,
            rotation_error: None,
            versions: None,
        };
        PageData::Batch(BatchData { title: title.to_owned(), cells: vec![cell], simulation: None })
    }

    #[test]
    fn names_cannot_end_the_data() {
        let page = page(&batch("<b>")).unwrap();
        let begin = page.find("id=\"data\">").unwrap() + "id=\"data\">".len();
        let end = begin + page[begin..].find("</script>").unwrap();
        let data: serde_json::Value = serde_json::from_str(&page[begin..end]).unwrap();
        assert_eq!(data["cells"][0]["scene"], "</script><script>alert(1)</script>");
        assert!(page.contains("<title>batch &lt;b&gt;</title>"), "the title is text");
    }

    #[test]
    fn pages_need_no_network() {
        let page = page(&batch("small")).unwrap();
        for reference in ["src=\"", "href=\"http", "@import", "url(http"] {
            assert!(!page.contains(reference), "{reference}");
        }
    }
}
