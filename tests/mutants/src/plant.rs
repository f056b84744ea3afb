//! Rewrites a source file so that it holds many mutants, each behind a switch: `crate::mutant::is(n)` is true while mutant `n` is on.

use crate::mutant::{Mutant, Place};
use proc_macro2::Span;
use quote::ToTokens;
use std::collections::BTreeMap;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Arm, BinOp, Block, Expr, ExprBinary, ExprStruct, Item, Member, Signature, parse_quote};

/// The source with the mutants in it. The numbers of those that stand in a constant are left in `mutants`, since a switch cannot be read there.
pub fn plant(source: &str, mutants: &mut BTreeMap<Place, Vec<Mutant>>) -> String {
    let mut file = syn::parse_file(source).expect("a source file that cargo-mutants has read");
    Planter { mutants }.visit_file_mut(&mut file);
    file.into_token_stream().to_string()
}

struct Planter<'a> {
    mutants: &'a mut BTreeMap<Place, Vec<Mutant>>,
}

impl Planter<'_> {
    /// The mutants of this genre that begin where the span does.
    fn take(&mut self, span: Span, genre: &str) -> Vec<Mutant> {
        let start = span.start();
        let place = (start.line, start.column + 1);
        let Some(here) = self.mutants.get_mut(&place) else {
            return Vec::new();
        };
        let (taken, left) = here.drain(..).partition(|mutant| mutant.genre == genre);
        *here = left;
        taken
    }

    /// A function returns the replacement at once.
    fn function(&mut self, signature: &Signature, body: &mut Block) {
        if signature.constness.is_some() {
            return;
        }
        let Some(first) = body.stmts.first() else {
            return;
        };
        let mutants = self.take(first.span(), "FnValue");
        visit_mut::visit_block_mut(self, body);
        for mutant in mutants.iter().rev() {
            let (number, value) = (mutant.number, parsed(&mutant.replacement));
            let early = parse_quote! { if crate::mutant::is(#number) { return #value; } };
            body.stmts.insert(0, early);
        }
    }

    fn binary(&mut self, binary: &ExprBinary) -> Option<Expr> {
        let mutants = self.take(binary.op.span(), "BinaryOperator");
        if mutants.is_empty() {
            return None;
        }
        let ExprBinary {
            left, op, right, ..
        } = binary;
        let choose = |a: Expr, b: Expr| {
            let mut chosen: Expr = parse_quote! { #a #op #b };
            for mutant in &mutants {
                let (number, other) = (mutant.number, operator(&mutant.replacement));
                chosen = parse_quote! { if crate::mutant::is(#number) { #a #other #b } else { #chosen } };
            }
            chosen
        };
        Some(match op {
            // The right side is evaluated only if the left side does not decide.
            BinOp::And(_) | BinOp::Or(_) => {
                let chosen = choose(parse_quote!(left), parse_quote!((#right)));
                parse_quote! { (match #left { left => #chosen }) }
            }
            BinOp::Eq(_)
            | BinOp::Ne(_)
            | BinOp::Lt(_)
            | BinOp::Le(_)
            | BinOp::Gt(_)
            | BinOp::Ge(_) => {
                let chosen = choose(parse_quote!(left), parse_quote!(right));
                parse_quote! { (match (&(#left), &(#right)) { (left, right) => #chosen }) }
            }
            _ if op.to_token_stream().to_string().ends_with('=') => {
                let chosen = choose(parse_quote!(#left), parse_quote!((#right)));
                parse_quote! { (#chosen) }
            }
            _ => {
                let chosen = choose(parse_quote!(left), parse_quote!(right));
                parse_quote! { (match (#left, #right) { (left, right) => #chosen }) }
            }
        })
    }
}

fn parsed(code: &str) -> Expr {
    syn::parse_str(code).unwrap_or_else(|_| panic!("no expression: {code}"))
}

fn operator(code: &str) -> BinOp {
    syn::parse_str(code).unwrap_or_else(|_| panic!("no operator: {code}"))
}

impl VisitMut for Planter<'_> {
    fn visit_item_mut(&mut self, item: &mut Item) {
        match item {
            Item::Const(_) | Item::Static(_) => {}
            _ => visit_mut::visit_item_mut(self, item),
        }
    }

    fn visit_impl_item_const_mut(&mut self, _: &mut syn::ImplItemConst) {}

    fn visit_trait_item_const_mut(&mut self, _: &mut syn::TraitItemConst) {}

    fn visit_type_mut(&mut self, _: &mut syn::Type) {}

    fn visit_generic_argument_mut(&mut self, _: &mut syn::GenericArgument) {}

    fn visit_variant_mut(&mut self, _: &mut syn::Variant) {}

    fn visit_expr_const_mut(&mut self, _: &mut syn::ExprConst) {}

    fn visit_expr_repeat_mut(&mut self, array: &mut syn::ExprRepeat) {
        self.visit_expr_mut(&mut array.expr);
    }

    fn visit_pat_mut(&mut self, _: &mut syn::Pat) {}

    fn visit_item_fn_mut(&mut self, function: &mut syn::ItemFn) {
        self.function(&function.sig, &mut function.block);
    }

    fn visit_impl_item_fn_mut(&mut self, function: &mut syn::ImplItemFn) {
        self.function(&function.sig, &mut function.block);
    }

    fn visit_trait_item_fn_mut(&mut self, function: &mut syn::TraitItemFn) {
        if let Some(body) = &mut function.default {
            self.function(&function.sig, body);
        }
    }

    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        visit_mut::visit_expr_mut(self, expression);
        let planted = match expression {
            Expr::Binary(binary) => self.binary(binary),
            Expr::Unary(unary) => {
                let mutants = self.take(unary.op.span(), "UnaryOperator");
                mutants.first().map(|mutant| {
                    let (number, value, op) = (mutant.number, &unary.expr, &unary.op);
                    parse_quote! { (match #value { value => if crate::mutant::is(#number) { value } else { #op value } }) }
                })
            }
            _ => None,
        };
        if let Some(planted) = planted {
            *expression = planted;
        }
    }

    fn visit_arm_mut(&mut self, arm: &mut Arm) {
        let deleted = self.take(arm.pat.span(), "MatchArm");
        let guards = arm.guard.as_ref().map(|(_, guard)| guard.span());
        let guards = guards.map_or(Vec::new(), |span| self.take(span, "MatchArmGuard"));
        visit_mut::visit_arm_mut(self, arm);
        for mutant in &guards {
            let (number, value) = (mutant.number, parsed(&mutant.replacement));
            let (_, guard) = arm.guard.as_mut().expect("a guard");
            **guard = parse_quote! { if crate::mutant::is(#number) { #value } else { #guard } };
        }
        for mutant in &deleted {
            let number = mutant.number;
            let guard: Expr = match &arm.guard {
                Some((_, guard)) => parse_quote! { !crate::mutant::is(#number) && (#guard) },
                None => parse_quote! { !crate::mutant::is(#number) },
            };
            arm.guard = Some((Default::default(), Box::new(guard)));
        }
    }

    fn visit_expr_struct_mut(&mut self, value: &mut ExprStruct) {
        let base = value.rest.clone();
        for field in &mut value.fields {
            let deleted = self.take(field.span(), "StructField");
            visit_mut::visit_expr_mut(self, &mut field.expr);
            if let (Some(mutant), Some(base), Member::Named(name)) =
                (deleted.first(), &base, &field.member)
            {
                let (number, kept) = (mutant.number, &field.expr);
                field.colon_token = Some(Default::default());
                field.expr =
                    parse_quote! { if crate::mutant::is(#number) { (#base).#name } else { #kept } };
            }
        }
        if let Some(rest) = &mut value.rest {
            self.visit_expr_mut(rest);
        }
    }
}
