//! The JSON Schema of what a person may write: that of the plain document's types, widened.

use crate::document::bounds::{MAX_ANGLE, MAX_LENGTH};
use crate::document::schema::Document;
use crate::source::expression::MAX_EXPRESSION;
use crate::source::parameters::{MAX_PARAMETER_NAME, MAX_PARAMETERS};
use serde_json::{Value, json};

/// The text of [`SCHEMA`](crate::document::schema::SCHEMA), anew from the types.
///
/// # Panics
/// Never: a schema is plain data.
pub fn schema() -> String {
    let schema = schemars::schema_for!(Document);
    let mut schema = serde_json::to_value(schema).expect("a schema is plain data");
    numbers(&mut schema, "");
    let properties = &mut schema["properties"];
    properties["angles"] = json!({
        "description": "The unit of all angles, and of those in expressions.",
        "enum": ["degrees", "radians"], "default": "degrees",
    });
    properties["parameters"] = json!({
        "description": "Numbers with names, which expressions use; each is a number or an expression of others.",
        "type": "object", "maxProperties": MAX_PARAMETERS,
        "propertyNames": {"pattern": "^[A-Za-z_][A-Za-z0-9_]*$", "maxLength": MAX_PARAMETER_NAME},
        "additionalProperties": {"type": ["number", "string"], "maxLength": MAX_EXPRESSION},
    });
    properties["home"] = json!({
        "description": "The workpiece's pose at the home position, in which chains are given by their axes.",
        "$ref": "#/$defs/FrameEntry",
    });
    let parts = &mut schema["$defs"];
    let list = |least: usize, most: f64, what: &str| {
        json!({
            "description": what, "type": "array", "minItems": least, "maxItems": least,
            "items": number(-most, most),
        })
    };
    for name in ["FrameEntry", "KeyFrameEntry"] {
        let fields = &mut parts[name]["properties"];
        let instead = "in place of longitude, latitude and roll";
        let of = |what: &str| format!("{what}, {instead}.");
        fields["quaternion_wxyz"] = list(
            4,
            MAX_LENGTH,
            &of("The rotation's quaternion, scalar first"),
        );
        fields["quaternion_xyzw"] =
            list(4, MAX_LENGTH, &of("The rotation's quaternion, scalar last"));
        fields["roll_pitch_yaw"] = list(
            3,
            MAX_ANGLE,
            &of("Three angles about the axes that order names"),
        );
        fields["matrix"] = json!({
            "description": of("The rotation's matrix, row by row"),
            "type": "array", "minItems": 3, "maxItems": 3, "items": list(3, MAX_LENGTH, "A row."),
        });
        fields["order"] = json!({
            "description": "Of roll_pitch_yaw: three axes, in lower case about fixed axes, in upper case about moving ones.",
            "type": "string", "pattern": "^([xyz]{3}|[XYZ]{3})$", "default": "xyz",
        });
    }
    parts["ChainEntry"]["properties"]["convention"] = json!({
        "description": "How rows are read: modified (Craig) is X(alpha, a) Z(theta, d), standard is Z(theta, d) X(alpha, a), whose last link goes to the gripper.",
        "enum": ["modified", "standard"], "default": "modified",
    });
    let joint = &mut parts["JointEntry"];
    let vector = |what: &str| list(3, MAX_LENGTH, what);
    let fields = &mut joint["properties"];
    fields["point"] =
        vector("In place of rows: a point of the joint, in the fixed frame at the home position.");
    fields["axis"] = vector("The direction of its axis, of any length but 0.");
    fields["second"] =
        vector("The direction of the second axis of a T, or of the first slider of an E.");
    joint["required"] = json!(["type"]);
    parts["JointKind"] = json!({
        "type": "string",
        "enum": ["R", "P", "C", "T", "S", "E", "U", "r", "p", "c", "t", "s", "e", "u"],
    });
    // In the order in which schemas are read.
    let schema = schemars::Schema::try_from(schema).expect("an object");
    serde_json::to_string_pretty(&schema).expect("plain data becomes JSON") + "\n"
}

fn number(least: f64, most: f64) -> Value {
    json!({"type": ["number", "string"], "minimum": least, "maximum": most, "maxLength": MAX_EXPRESSION})
}

/// Lets every number be an expression, but the version.
fn numbers(schema: &mut Value, field: &str) {
    match schema {
        Value::Object(fields) => {
            let kinds = ["number", "integer"];
            let is_number = |kind: &Value| kind.as_str().is_some_and(|kind| kinds.contains(&kind));
            let kind = fields.get("type").cloned();
            match kind {
                Some(kind) if is_number(&kind) && field != "version" => {
                    fields.insert("type".to_owned(), json!([kind, "string"]));
                    fields.insert("maxLength".to_owned(), json!(MAX_EXPRESSION));
                }
                Some(Value::Array(mut list)) if list.iter().any(is_number) => {
                    list.push(json!("string"));
                    fields.insert("type".to_owned(), Value::Array(list));
                    fields.insert("maxLength".to_owned(), json!(MAX_EXPRESSION));
                }
                _ => {}
            }
            for (name, value) in fields.iter_mut() {
                // A default is a value, and no schema.
                if name != "default" {
                    numbers(value, name);
                }
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| numbers(item, field)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}
