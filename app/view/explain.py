"""The words behind the pictures, one click away from them."""

READING = r"""
**gamma-space** holds what is learned: for each discount $\gamma$ and sensitivity $\theta_h$, the discounted number
of future rewards above the threshold. Drawn are the differences between neighbouring thresholds, with $k$ the slope:

$$
Z_{\gamma,h} = \mathbb{E}\sum_{\tau\ge 0} \gamma^\tau \big[f_h(r_\tau) - f_{h+1}(r_\tau)\big]
$$

$$
f_h(r) = \frac{1}{1+e^{-k\,(r-\theta_h)}}
$$

**tau-space** is its inverse: how likely each reward is at each future step. With $F_{\gamma\tau}=\gamma^\tau$:

$$
P = V\,\mathrm{diag}\!\Big(\frac{s}{s^2+\alpha^2}\Big)\,U^\top Z, \qquad F = U\,\mathrm{diag}(s)\,V^\top
$$

White outlines (orange lines on a surface) are the truth; red is negative probability, which only an inverse can make.
All sensitivities are drawn equally wide and all discounts equally high, whatever lies between them.

**Survival** is the decoded constant channel ($f\equiv 1$): the chance that the episode still runs at $\tau$.

**Values over the horizon** add up expected rewards until the deadline; softness $w$ blurs it, and $w \to 0$ counts
the steps before $T$:

$$
V_T = \sum_\tau \gamma^\tau\, d_T(\tau) \sum_h \hat\theta_h P_{\tau h}, \qquad
d_T(\tau) = \frac{1}{1+e^{-(T-\frac12-\tau)/(wT)}}
$$

Solid lines are decoded; dotted ones are true, under the policy for the acting gamma and the same deadline. The strip
compares the chosen action with the best one, found by backward induction for every hard deadline.

**The verdict** is computed: a cause is named only if its remedy alone puts the choice right.
"""

TRAINING = r"""
**Return.** Faint: the return of each episode while training, exploration included; where there are very many, a mean
over neighbours. Dotted: its moving average. Solid: evaluation, whole episodes without exploration from start seeds
that are never trained on, with the standard error of their mean. The checkpoint that is kept is that of the best one.
Grey, where agents of this algorithm and environment ship: their evaluations, the median of the seeds dashed, from the
lowest to the highest shaded.

**Values too high or too low.** At each evaluation the agent predicts at the start its return at every discount
$\gamma$, and then acts. Drawn is the difference to what is observed, per step of its time constant:

$$
(1-\gamma)\Big(V_\gamma(s_0) - \sum_\tau \gamma^\tau r_\tau\Big)
$$

It goes to 0 as a discount is learned; small discounts come first. Episodes that the time limit cuts off lack what would
have come after it, so large discounts may stay above 0 there. Where each discount follows a policy of its own, their
values are of those policies, and the returns of the acting one.

**Value at the start** is the last of these evaluations, not scaled, with the standard error of what is observed: where
rewards are random, a few episodes say little. A gap at large $1/(1-\gamma)$ alone says that the far future is not
learned yet.
"""
