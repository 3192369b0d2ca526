//! An interpreter of the functions that `shader` writes, in f64: the part of GLSL and WGSL that
//! they use. It shares no code with the program.

use std::collections::HashMap;

/// A function `irradiance`, as a text in which it is the last function.
pub struct Function(Vec<String>);

impl Function {
    pub fn new(text: &str) -> Self {
        let function = text.split_once("irradiance(").expect("a function").1;
        Self(tokens(function.split_once('{').expect("a body").1))
    }

    /// The irradiance of these normals, channel after channel, where the array `eigenshade` holds
    /// these vectors.
    pub fn values(&self, vectors: &[[f64; 4]], normals: &[[f64; 3]]) -> Vec<f64> {
        normals.iter().flat_map(|&normal| self.irradiance(vectors, normal)).collect()
    }

    fn irradiance(&self, vectors: &[[f64; 4]], normal: [f64; 3]) -> [f64; 3] {
        let variables = HashMap::from([("normal", normal.to_vec())]);
        let mut run = Run { tokens: &self.0, at: 0, vectors, variables };
        let result = run.block().expect("an irradiance that is returned");
        assert!(result.iter().all(|number| number.is_finite()), "{normal:?}: {result:?}");
        result.try_into().expect("three channels")
    }
}

/// A number, or the components of a vector.
type Value = Vec<f64>;

struct Run<'a> {
    tokens: &'a [String],
    at: usize,
    vectors: &'a [[f64; 4]],
    variables: HashMap<&'a str, Value>,
}

impl<'a> Run<'a> {
    fn next(&mut self) -> &'a str {
        self.at += 1;
        &self.tokens[self.at - 1]
    }

    fn is_next(&mut self, token: &str) -> bool {
        let is = self.tokens[self.at] == token;
        self.at += usize::from(is);
        is
    }

    /// Skips these tokens, which blanks separate.
    fn expect(&mut self, tokens: &str) {
        for token in tokens.split(' ') {
            let found = self.next();
            assert_eq!(found, token, "before {:?}", &self.tokens[self.at..][..4]);
        }
    }

    /// Statements up to a closing brace, or to one that returns.
    fn block(&mut self) -> Option<Value> {
        let mut result = None;
        while result.is_none() && !self.is_next("}") {
            let first = self.next();
            match first {
                "return" => result = Some(self.sum()),
                "for" => result = self.repeat(),
                "if" => {
                    self.expect("(");
                    let left = self.number();
                    self.expect(">");
                    let is_true = left > self.number();
                    self.expect(") {");
                    if is_true {
                        result = self.block();
                    } else {
                        self.skip_block();
                    }
                }
                "float" | "vec3" | "vec4" | "let" | "var" => loop {
                    let name = self.next();
                    if self.is_next(":") {
                        self.next();
                    }
                    if self.is_next("=") {
                        let value = self.sum();
                        let length = match first {
                            "float" => 1,
                            "vec3" => 3,
                            "vec4" => 4,
                            _ => value.len(),
                        };
                        assert_eq!(value.len(), length, "{first} {name}");
                        self.variables.insert(name, value);
                    }
                    if self.is_next(";") {
                        break;
                    }
                    self.expect(",");
                },
                _ => {
                    let value = if self.is_next("+=") {
                        let more = self.sum();
                        by_component(&self.variables[first], &more, |a, b| a + b)
                    } else {
                        self.expect("=");
                        self.sum()
                    };
                    self.variables.insert(first, value);
                    self.expect(";");
                }
            }
        }
        result
    }

    /// `for (int k = 1; k < 9; k += 4) { .. }`
    fn repeat(&mut self) -> Option<Value> {
        self.expect("(");
        assert!(self.is_next("int") || self.is_next("var"));
        let name = self.next();
        self.expect("=");
        let mut k = self.number();
        self.expect(&format!("; {name} <"));
        let end = self.number();
        self.expect(&format!("; {name} +="));
        let step = self.number();
        self.expect(") {");
        let body = self.at;
        while k < end {
            self.at = body;
            self.variables.insert(name, vec![k]);
            if let Some(result) = self.block() {
                return Some(result);
            }
            k += step;
        }
        self.at = body;
        self.skip_block();
        None
    }

    fn skip_block(&mut self) {
        let mut open = 1;
        while open > 0 {
            match self.next() {
                "{" => open += 1,
                "}" => open -= 1,
                _ => {}
            }
        }
    }

    fn number(&mut self) -> f64 {
        let value = self.sum();
        assert_eq!(value.len(), 1, "a number before {:?}", &self.tokens[self.at..][..4]);
        value[0]
    }

    fn sum(&mut self) -> Value {
        let mut sum = self.product();
        loop {
            if self.is_next("+") {
                sum = by_component(&sum, &self.product(), |a, b| a + b);
            } else if self.is_next("-") {
                sum = by_component(&sum, &self.product(), |a, b| a - b);
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> Value {
        let mut product = self.part();
        loop {
            if self.is_next("*") {
                product = by_component(&product, &self.part(), |a, b| a * b);
            } else if self.is_next("/") {
                let divisor = self.part();
                assert!(divisor.iter().all(|&number| number > 0.0), "a divisor: {divisor:?}");
                product = by_component(&product, &divisor, |a, b| a / b);
            } else {
                return product;
            }
        }
    }

    /// An operand, or a part of it.
    fn part(&mut self) -> Value {
        let mut value = self.operand();
        while self.is_next(".") {
            let letters = self.next();
            let place = |letter| {
                let both = ["xyzw", "rgba"].into_iter().find_map(|all| all.find(letter));
                both.unwrap_or_else(|| panic!("a component: {letter}"))
            };
            value = letters.chars().map(|letter| value[place(letter)]).collect();
        }
        value
    }

    fn operand(&mut self) -> Value {
        let token = self.next();
        match token {
            "(" => {
                let sum = self.sum();
                self.expect(")");
                sum
            }
            "eigenshade" => {
                self.expect("[");
                let place = self.number();
                self.expect("]");
                self.vectors[place as usize].to_vec()
            }
            "texelFetch" => {
                self.expect("( eigenshade , ivec2 (");
                let place = self.number();
                self.expect(", 0 ) , 0 )");
                self.vectors[place as usize].to_vec()
            }
            "vec3" | "vec3f" | "dot" | "sqrt" | "max" => {
                self.expect("(");
                let mut arguments = vec![self.sum()];
                while self.is_next(",") {
                    arguments.push(self.sum());
                }
                self.expect(")");
                call(token, &arguments)
            }
            number if number.starts_with(|c: char| c.is_ascii_digit()) => {
                vec![number.parse().expect("a number")]
            }
            name => self.variables.get(name).unwrap_or_else(|| panic!("no `{name}`")).clone(),
        }
    }
}

fn call(name: &str, arguments: &[Value]) -> Value {
    match (name, arguments) {
        ("vec3" | "vec3f", [number]) if number.len() == 1 => vec![number[0]; 3],
        ("vec3" | "vec3f", [x, y, z]) => [x, y, z].map(|number| number[0]).to_vec(),
        ("dot", [a, b]) if a.len() == b.len() => vec![a.iter().zip(b).map(|(a, b)| a * b).sum()],
        ("sqrt", [number]) if number[0] >= 0.0 => vec![number[0].sqrt()],
        ("max", [a, b]) => by_component(a, b, f64::max),
        _ => panic!("{name} of {arguments:?}"),
    }
}

fn by_component(a: &[f64], b: &[f64], of: impl Fn(f64, f64) -> f64) -> Value {
    let length = a.len().max(b.len());
    let fits = |value: &[f64]| value.len() == 1 || value.len() == length;
    assert!(fits(a) && fits(b), "{a:?} and {b:?}");
    let component = |value: &[f64], k: usize| if value.len() == 1 { value[0] } else { value[k] };
    (0..length).map(|k| of(component(a, k), component(b, k))).collect()
}

fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_digit() {
            // A sign within a number follows its `e`.
            let mut before = ' ';
            let ends = |c: char| {
                let is_sign = c == '-' && before == 'e';
                before = c;
                !(c.is_ascii_digit() || c == '.' || c == 'e' || is_sign)
            };
            rest.find(ends)
        } else if first.is_ascii_alphabetic() {
            rest.find(|c: char| !c.is_ascii_alphanumeric())
        } else {
            Some(if rest.starts_with("+=") { 2 } else { 1 })
        };
        let (token, after) = rest.split_at(length.unwrap_or(rest.len()));
        tokens.push(token.to_owned());
        rest = after.trim_start();
    }
    tokens
}
