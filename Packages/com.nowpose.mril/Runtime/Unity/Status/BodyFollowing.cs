using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Computes the pose of a panel that follows its reader's body: it stays in place in the world until the head has turned or moved too
    /// far, then glides in front of it, and stays again.
    /// </summary>
    struct BodyFollowing
    {
        const float SettledDegrees = 0.5f;
        const float SettledMetres = 0.005f;

        bool _isPlaced;

        public bool IsGliding { get; private set; }

        /// <returns>The new pose; exactly the current one unless the panel glides. The first pose is in front of the head.</returns>
        public Pose Next(Pose panel, Pose head, in FollowSettings settings, float seconds)
        {
            var below = settings.DegreesBelow * Mathf.Deg2Rad;
            var goal = new AroundHead(
                AroundHead.HeadingOf(head.rotation), settings.Distance * Mathf.Cos(below), -settings.Distance * Mathf.Sin(below));
            if (!_isPlaced)
            {
                _isPlaced = true;
                return goal.From(head.position);
            }
            var place = AroundHead.Of(panel.position, head.position);
            if (!IsGliding && place.IsWithin(settings.TurnDegrees, settings.MoveMetres, goal)) return panel;
            // A started glide continues to its end; otherwise the panel would stop at the limit and restart with every nod.
            place = place.Towards(goal, 1 - Mathf.Exp(-seconds / settings.GlideSeconds));
            IsGliding = !place.IsWithin(SettledDegrees, SettledMetres, goal);
            return place.From(head.position);
        }
    }
}
