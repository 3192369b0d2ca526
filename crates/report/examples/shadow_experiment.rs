fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let size = args[0].parse().unwrap();
    let names: Vec<&str> = args[1..].iter().map(String::as_str).collect();
    report::shadows::experiment(size, &names, "tables/inputs/maps").unwrap();
}
