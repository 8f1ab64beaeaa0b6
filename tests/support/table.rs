//! Tables that the program writes.

/// A CSV table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    pub header: String,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    pub fn parse(text: &str) -> Self {
        let mut lines = text.lines();
        let header = lines.next().unwrap_or_default().to_owned();
        Self { header, rows: lines.map(cells).collect() }
    }

    /// Index of a column.
    #[track_caller]
    pub fn index(&self, column: &str) -> usize {
        let found = self.header.split(',').position(|name| name == column);
        found.unwrap_or_else(|| panic!("no column {column} in {}", self.header))
    }

    /// The cells of a column.
    #[track_caller]
    pub fn column(&self, column: &str) -> Vec<&str> {
        let index = self.index(column);
        self.rows.iter().map(|row| row[index].as_str()).collect()
    }

    /// Numbers from a column on, in rows.
    #[track_caller]
    pub fn numbers_from(&self, column: &str) -> Vec<Vec<f64>> {
        let index = self.index(column);
        self.rows.iter().map(|row| numbers(&row[index..])).collect()
    }

    /// Columns that are not these, in rows.
    pub fn without(&self, columns: &[&str]) -> Vec<Vec<String>> {
        let kept: Vec<usize> =
            self.header.split(',').enumerate().filter(|(_, name)| !columns.contains(name)).map(|(at, _)| at).collect();
        self.rows.iter().map(|row| kept.iter().map(|&index| row[index].clone()).collect()).collect()
    }
}

/// Cells of a line; commas between quotes belong to their cell.
fn cells(line: &str) -> Vec<String> {
    let mut is_quoted = false;
    let mut ends_cell = |letter: char| {
        is_quoted ^= letter == '"';
        letter == ',' && !is_quoted
    };
    line.split(&mut ends_cell).map(|cell| cell.trim_matches('"').to_owned()).collect()
}

/// Cells as numbers.
#[track_caller]
pub fn numbers(cells: &[String]) -> Vec<f64> {
    cells.iter().map(|cell| cell.parse().unwrap_or_else(|_| panic!("{cell} is not a number"))).collect()
}

/// Euclidean norm of some cells.
pub fn norm(cells: &[String]) -> f64 {
    numbers(cells).iter().map(|number| number * number).sum::<f64>().sqrt()
}
