//! A value of JSON.

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// `null` or `false`.
    No,
    /// `true`.
    Yes,
    Number(f64),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(&'static str, Json)>),
}

impl Json {
    /// The value of a name in an object.
    pub fn get(&self, name: &str) -> Option<&Json> {
        match self {
            Json::Object(all) => all.iter().find(|(own, _)| *own == name).map(|(_, v)| v),
            _ => None,
        }
    }

    /// The values of a list; empty for anything else.
    pub fn list(&self) -> &[Json] {
        match self {
            Json::List(all) => all,
            _ => &[],
        }
    }

    /// The list under a name in an object; empty if there is none.
    pub fn list_of(&self, name: &str) -> &[Json] {
        self.get(name).map_or(&[], Json::list)
    }

    pub fn number(&self) -> Option<f64> {
        match self {
            Json::Number(x) => Some(*x),
            _ => None,
        }
    }

    pub fn text(&self) -> Option<&str> {
        match self {
            Json::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The value as an integer from 0 to 2^32 - 1.
    pub fn index(&self) -> Option<usize> {
        let x = self.number()?;
        let index = x as u32;
        (f64::from(index) == x).then_some(index as usize)
    }

    /// The integer under a name in an object.
    pub fn index_of(&self, name: &str) -> Option<usize> {
        self.get(name)?.index()
    }
}
