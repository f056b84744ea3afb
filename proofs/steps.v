(* Steps between the scripts of Gappa, in real numbers: a phase of velocity v, acceleration a and jerk j, at times z from 0 to its end d. *)
Require Import Reals Psatz.
From Flocq Require Import Core.
Open Scope R_scope.

Definition velocity v a j z := v + z * (a + z * j / 2).

(* The velocity is highest at the start, at the end, or where the acceleration is 0. The lowest one is the highest one of -v, -a, -j. *)
Lemma extreme v a j d z : 0 <= z <= d ->
  velocity v a j z <= velocity v a j 0 \/ velocity v a j z <= velocity v a j d
  \/ exists c, 0 < c < d /\ a + c * j = 0 /\ velocity v a j z <= velocity v a j c.
Proof.
  unfold velocity; intros Z.
  destruct (Rle_or_lt 0 j) as [J | J].
  - destruct (Rle_or_lt 0 (a + z * j / 2)) as [R | R].
    + right; left.
      assert (0 <= (d - z) * (a + z * j / 2)) by (apply Rmult_le_pos; lra).
      assert (0 <= (d - z) * (d * j)) by (repeat apply Rmult_le_pos; lra).
      lra.
    + left; assert (0 <= z * - (a + z * j / 2)) by (apply Rmult_le_pos; lra); lra.
  - assert (a + (- a / j) * j = 0) as C by (field; lra).
    set (c := - a / j) in *; replace a with (- c * j) by lra.
    destruct (Rle_or_lt c 0).
    { left; assert (0 <= z * (- j * (z / 2 - c))) by (repeat apply Rmult_le_pos; lra); lra. }
    destruct (Rle_or_lt d c).
    { right; left; assert (0 <= (d - z) * (- j * (c - (d + z) / 2))) by (repeat apply Rmult_le_pos; lra); lra. }
    right; right; exists c; repeat split; try lra.
    assert (0 <= - j * Rsqr (z - c)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]); unfold Rsqr in *; lra.
Qed.

(* At another time it is short of the extreme by the square of the distance. *)
Lemma short v a j c x : a + c * j = 0 -> velocity v a j c - velocity v a j x = - j / 2 * (x - c) * (x - c).
Proof.
  unfold velocity; intros; replace a with (- c * j) by lra; field.
Qed.

(* No term is above the scale of the check: A is the highest acceleration. *)
Lemma terms a j d z A : 0 <= z <= d -> 0 < d -> Rabs a <= A -> Rabs (a + d * j) <= A ->
  Rabs (a + z * j / 2) <= A /\ Rabs (z * j / 2) <= A /\ Rabs (a / 2 + z * j / 6) <= A / 2 /\ Rabs (z * j / 6) <= A / 3.
Proof.
  intros Z D B C.
  apply Rabs_le_inv in B; apply Rabs_le_inv in C.
  assert (exists s, 0 <= s <= 1 /\ z = s * d) as [s [S E]].
  { exists (z / d); split; [| field; lra].
    split; [apply Rle_mult_inv_pos; lra | apply Rmult_le_reg_r with d; [lra |]].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  subst z; set (g := d * j) in *; replace (s * d * j) with (s * g) by (unfold g; ring).
  repeat split; apply Rabs_le; nra.
Qed.

(* A rounded acceleration does not leave the values at the start and at the end of its phase. *)
Lemma acceleration fexp (_ : Valid_exp fexp) a j z d : 0 <= z <= d ->
  let rnd := round radix2 fexp ZnearestE in
  let f z := rnd (a + rnd (z * j)) in
  (f 0 <= f z <= f d) \/ (f d <= f z <= f 0).
Proof.
  intros Z rnd f; unfold f, rnd.
  destruct (Rle_or_lt 0 j); [left | right]; split; repeat (apply round_le; auto with typeclass_instances; try apply Rplus_le_compat_l);
    nra.
Qed.
