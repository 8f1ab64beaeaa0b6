//! ipopt-sys
